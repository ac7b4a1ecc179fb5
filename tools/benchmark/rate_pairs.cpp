// SPDX-License-Identifier: Apache-2.0
// Names and pairs of the highest clean rates.
#include "tools/benchmark/clean_rates.hpp"

#include <fmt/format.h>

namespace benchmarks {

namespace {

constexpr const char* lines = "lines of 500 ticks";
constexpr const char* one_line = "one line";

CleanPair pair_of(const char* program, std::size_t axes, std::uint32_t guard, const char* motion) {
  CleanPair pair;
  pair.text = fmt::format("{}, {} {}, guard {}, {}", program, axes, axes == 1 ? "axis" : "axes",
                          guard, motion);
  for (const char character : pair.text) {
    if (character != ',') pair.name += character == ' ' ? '_' : character;
  }
  return pair;
}

}  // namespace

std::vector<CleanPair> clean_pairs(const Comparison& comparison) {
  std::vector<CleanPair> pairs;
  const auto& hardware = comparison.figures[0].clean;
  const auto& software = comparison.figures[1].clean;
  for (std::size_t i = 0; i < hardware.size(); ++i) {
    const auto add = [&](const char* motion, std::uint32_t hard, std::uint32_t soft) {
      CleanPair& pair = pairs.emplace_back(
          pair_of("bare loop", hardware[i].axes, hardware[i].guard_clocks, motion));
      pair.hardware_clocks = hard;
      pair.software_clocks = soft;
    };
    add(lines, hardware[i].lines_clocks, software[i].lines_clocks);
    add(one_line, hardware[i].one_line_clocks, software[i].one_line_clocks);
  }
  const auto& hard_prints = comparison.printing[0];
  const auto& soft_prints = comparison.printing[1];
  for (std::size_t i = 0; i < hard_prints.size(); ++i) {
    const auto add = [&](const char* motion, const PrintingLimit& hard, const PrintingLimit& soft) {
      CleanPair& pair =
          pairs.emplace_back(pair_of("whole firmware", hard_prints[i].axes, 1, motion));
      pair.hardware_clocks = hard.interval_clocks;
      pair.software_clocks = soft.interval_clocks;
      pair.hardware_limited_by = hard.limited_by;
      pair.software_limited_by = soft.limited_by;
    };
    add(lines, hard_prints[i].lines, soft_prints[i].lines);
    add(one_line, hard_prints[i].one_line, soft_prints[i].one_line);
  }
  return pairs;
}

}  // namespace benchmarks
