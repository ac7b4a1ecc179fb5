// SPDX-License-Identifier: Apache-2.0
// The tools as the machine description has them.
#include "application/tools.hpp"

namespace application {

void Tools::restore(const MachineDescription& machine) {
  if constexpr (units::most_tools > 1) {
    if (!machine.second_tool.has_value()) return;
    state().count = 2;
    state().offsets.front() = {};
    state().offsets.back() = machine.second_tool->offset;
    state().change = machine.second_tool->change;
  }
}

}  // namespace application
