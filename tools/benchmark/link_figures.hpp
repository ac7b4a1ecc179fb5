// SPDX-License-Identifier: Apache-2.0
// What `bench link` measures: how many lines a second go through the serial line, how soon a line
// is answered, and how long a print of short segments takes after it.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tools/benchmark/link_run.hpp"

namespace benchmarks {

struct LinkScope {
  std::map<std::uint32_t, sim::ElfImage> firmware;  // by the baud rate that it is built for
  machine::Description machine;  // that it is built for otherwise
  bool quick = false;  // few lines, to see that all works
  std::function<void()> look = [] {};  // called many times a second; what it throws ends all
};

struct LinkFigure {
  std::uint32_t clock_hz{};
  std::uint32_t baud{};
  std::size_t window{};
  double line_limit{};  // lines/s that the bits of line and reply permit
  LinkRun run;
};

// Of urgent commands, while lines of a job wait.
struct UrgentFigure {
  std::uint32_t clock_hz{};
  bool numbered{};
  double mean_answer_us{}, longest_answer_us{};  // of M105
  double mean_stop_us{}, longest_stop_us{};  // of M112
};

struct LinkFigures {
  std::vector<LinkFigure> rates;  // lines of 27 characters
  std::vector<LinkFigure> short_lines;  // of 8 characters, one in flight
  std::vector<LinkFigure> arcs;  // 1200 segments of 0.2 mm
  std::vector<UrgentFigure> urgent;  // at the lowest baud rate
};

LinkFigures measure_link(const LinkScope& scope,
                         const std::function<void(const std::string&)>& say);

std::string to_json(const LinkFigures& figures);
std::string to_table(const LinkFigures& figures);

}  // namespace benchmarks
