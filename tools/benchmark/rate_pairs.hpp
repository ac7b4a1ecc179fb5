// SPDX-License-Identifier: Apache-2.0
// The highest rates of both ways to make steps side by side, whatever requests the steps: the bare
// stepping loop or the whole firmware.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tools/benchmark/stepping_report.hpp"

namespace benchmarks {

struct RatePair {
  std::string name;  // such as whole_firmware_1_axis_guard_1_lines_of_500_ticks
  std::string text;  // the same for a person
  Limits hardware, software;  // clocks per step of the leading axis

  double ratio(Rule rule) const {
    return static_cast<double>(software.of(rule).interval_clocks) /
           hardware.of(rule).interval_clocks;
  }
};

std::vector<RatePair> rate_pairs(const Comparison& comparison);

}  // namespace benchmarks
