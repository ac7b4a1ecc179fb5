// SPDX-License-Identifier: Apache-2.0
// Inputs that are long work by construction: the first ones of a search.
#pragma once

#include <vector>

#include "tools/worst_inputs/serial_input.hpp"

namespace worst_inputs {

// Each begins from what any other leaves: lines have no number, or begin with M110.
std::vector<SerialInput> hard_inputs();

}  // namespace worst_inputs
