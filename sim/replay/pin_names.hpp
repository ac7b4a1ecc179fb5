// SPDX-License-Identifier: Apache-2.0
// Names of output pins, for messages.
#pragma once

#include <cstdint>
#include <string>

namespace replay {

// Of the bits of OutputPins::word that are 1 in `pins`.
std::string pin_names(std::uint64_t pins);

}  // namespace replay
