// SPDX-License-Identifier: Apache-2.0
// Where an end stop lies, in steps of the motors.
#pragma once

#include <array>
#include <cstdint>

namespace devices {

// Closed where the motors' positions (x y z e) times these weights are at most `at` in sum.
struct SwitchPlace {
  std::array<std::int64_t, 4> weights{};
  std::int64_t at{};
};

}  // namespace devices
