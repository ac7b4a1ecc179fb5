// SPDX-License-Identifier: Apache-2.0
// Hotend and bed of the default machine's description, as the simulated printer has them.
#pragma once

#include "tests/default_machine.hpp"

namespace tests {

inline plants::HeatedBlockProperties described_hotend() {
  static const auto machine = default_machine();
  return machine.hotend.block;
}

inline plants::HeatedBlockProperties described_bed() {
  static const auto machine = default_machine();
  return machine.bed.block;
}

}  // namespace tests
