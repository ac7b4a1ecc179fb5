// SPDX-License-Identifier: Apache-2.0
// What a printer is doing when an input reaches it.
#pragma once

#include <string_view>
#include <vector>

#include "tools/worst_inputs/serial_input.hpp"

namespace worst_inputs {

struct Start {
  std::string_view name;
  SerialInput input;  // what a host has sent to the homed and warm printer before
};

// The first one is the printer at rest.
std::vector<Start> starts();

}  // namespace worst_inputs
