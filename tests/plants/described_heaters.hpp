// SPDX-License-Identifier: Apache-2.0
// Hotend and bed of the default machine's description, as the simulated printer has them.
#pragma once

#include "directories.hpp"
#include "sim/machine/description.hpp"

namespace tests {

inline plants::HeatedBlockProperties described_hotend() {
  static const auto machine =
      machine::read_description(PROJECT_DIRECTORY "/firmware/machines/prusa_mendel.toml");
  return machine.hotend.block;
}

inline plants::HeatedBlockProperties described_bed() {
  static const auto machine =
      machine::read_description(PROJECT_DIRECTORY "/firmware/machines/prusa_mendel.toml");
  return machine.bed.block;
}

}  // namespace tests
