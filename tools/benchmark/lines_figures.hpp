// SPDX-License-Identifier: Apache-2.0
// What `bench lines` measures: how many printing lines a second the chip executes at 50 MHz, and
// where its clocks go.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tools/benchmark/link_run.hpp"

namespace benchmarks {

struct LinesProgram {
  std::uint32_t baud{};
  std::uint32_t memory_bytes{};  // of the chip
  std::filesystem::path file;
};

struct LinesScope {
  std::vector<LinesProgram> programs;
  machine::Description machine;
  bool quick = false;
  std::function<void()> look = [] {};  // called many times a second; what it throws ends all
};

struct LinesFigure {
  std::uint32_t baud{};
  std::uint32_t memory_kib{};
  std::size_t window{};  // lines in flight
  double lines_per_second{};
  double line_limit{};  // lines/s that the bits permit
  double busy_percent{};
  double clocks_per_line{};  // in which the processor is awake
  std::uint64_t underruns{};
  std::map<std::string, double> parts;  // of clocks_per_line, see clock_parts.hpp
};

std::vector<LinesFigure> measure_lines(const LinesScope& scope,
                                       const std::function<void(const std::string&)>& say);

std::string to_json(const std::vector<LinesFigure>& figures);
std::string to_table(const std::vector<LinesFigure>& figures);

}  // namespace benchmarks
