// SPDX-License-Identifier: Apache-2.0
// The description of the default machine.
#pragma once

#include "directories.hpp"
#include "sim/machine/description.hpp"

namespace tests {

inline machine::Description default_machine() {
  return machine::read_description(PROJECT_DIRECTORY "/firmware/machines/prusa_mendel.toml");
}

}  // namespace tests
