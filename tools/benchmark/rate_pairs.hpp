// SPDX-License-Identifier: Apache-2.0
// The highest clean rates of both ways to make steps side by side, whoever asked for the steps: the
// bare stepping loop or the whole firmware.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/benchmark/stepping_report.hpp"

namespace benchmarks {

struct CleanPair {
  std::string name;  // such as whole_firmware_1_axis_guard_1_lines_of_500_ticks
  std::string text;  // the same for a person
  std::uint32_t hardware_clocks{};  // per step of the leading axis
  std::uint32_t software_clocks{};
  std::string hardware_limited_by;  // only of the whole firmware; empty where nothing is faster
  std::string software_limited_by;

  double ratio() const { return static_cast<double>(software_clocks) / hardware_clocks; }
};

std::vector<CleanPair> clean_pairs(const Comparison& comparison);

}  // namespace benchmarks
