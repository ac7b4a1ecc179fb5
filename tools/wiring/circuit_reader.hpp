// SPDX-License-Identifier: Apache-2.0
// Reads kinds of parts, the header and the circuits with their copies.
#pragma once

#include "tools/wiring/description.hpp"
#include "tools/wiring/toml_reader.hpp"

namespace wiring {

// The description has its values already.
void read_circuits(const TomlReader& reader, Description& description);

}  // namespace wiring
