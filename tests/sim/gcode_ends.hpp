// SPDX-License-Identifier: Apache-2.0
// Where a line of G-code leads, by the report's reader.
#pragma once

#include <gmock/gmock.h>

#include <array>

#include "sim/report/gcode_path.hpp"

namespace tests {

// In millimetres.
inline std::array<double, 4> place(const report::GcodePath& path) {
  std::array<double, 4> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = report::millimeters(path.position()[i]);
  }
  return result;
}

inline std::array<double, 4> end_of(report::GcodePath& path, std::string_view command) {
  const report::Request request = path.read(command);
  EXPECT_TRUE(std::holds_alternative<report::Move>(request)) << command;
  return place(path);
}

}  // namespace tests
