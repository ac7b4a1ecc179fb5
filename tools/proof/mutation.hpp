// SPDX-License-Identifier: Apache-2.0
// Putting a fault into a copy of the sources.
#pragma once

#include <string>

#include "tools/proof/list.hpp"

namespace proof {

// The text with the mutation in it. Throws std::runtime_error where `from` does not stand there
// exactly once, or changes nothing: a mutation that does not apply shows nothing.
std::string mutated(const std::string& text, const Mutation& mutation);

}  // namespace proof
