// SPDX-License-Identifier: Apache-2.0
// Names and pairs of the highest rates.
#include "tools/benchmark/rate_pairs.hpp"

#include <fmt/format.h>

namespace benchmarks {

namespace {

constexpr const char* lines = "lines of 500 ticks";
constexpr const char* one_line = "one line";

RatePair pair_of(const char* program, std::size_t axes, const DriverGuard& guard,
                 const char* motion, const Limits& hardware, const Limits& software) {
  RatePair pair{.name = {},
                .text = fmt::format("{}, {} {}, {}, {}", program, axes, axes == 1 ? "axis" : "axes",
                                    guard.driver, motion),
                .hardware = hardware,
                .software = software};
  for (const char character : pair.text) {
    if (character != ',') pair.name += character == ' ' ? '_' : character;
  }
  return pair;
}

}  // namespace

std::vector<RatePair> rate_pairs(const Comparison& comparison) {
  std::vector<RatePair> pairs;
  const auto add = [&](const char* program, const DriverGuard& guard, const auto& hardware,
                       const auto& software) {
    pairs.push_back(pair_of(program, hardware.axes, guard, lines, hardware.lines, software.lines));
    pairs.push_back(
        pair_of(program, hardware.axes, guard, one_line, hardware.one_line, software.one_line));
  };
  const auto& hardware_loops = comparison.figures[0].loops;
  const auto& software_loops = comparison.figures[1].loops;
  for (std::size_t i = 0; i < hardware_loops.size(); ++i) {
    add("bare loop", hardware_loops[i].guard, hardware_loops[i], software_loops[i]);
  }
  const auto& hardware_prints = comparison.printing[0];
  const auto& software_prints = comparison.printing[1];
  for (std::size_t i = 0; i < hardware_prints.size(); ++i) {
    add("whole firmware", no_driver, hardware_prints[i], software_prints[i]);
  }
  return pairs;
}

}  // namespace benchmarks
