// SPDX-License-Identifier: Apache-2.0
// Reports the figures of `bench stepping`: to programs, on the terminal, as a picture and
// as a page.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "tools/benchmark/printing_figures.hpp"
#include "tools/benchmark/stepping_figures.hpp"

namespace benchmarks {

// A print with either stepping, from its report.json.
struct PrintFigure {
  std::string result;
  std::uint64_t late_ticks{}, underruns{}, illegal_pulses{};
  double busy_percent{}, max_deviation_mm{}, seconds{};
  double max_step_rate_hz{};
  bool same_steps{};  // as in hardware, forward and backward on each axis
};

struct Comparison {
  std::uint32_t clock_hz{};
  double tolerance_us{};  // of the punctual rates
  std::array<Figures, 2> figures;  // hardware, software
  std::array<std::vector<PrintingRates>, 2> printing;  // the same, of the whole firmware
  std::uint32_t print_clock_hz{};
  std::string print_file;
  std::optional<std::array<PrintFigure, 2>> prints;
};

std::string to_json(const Comparison& comparison);
std::string to_table(const Comparison& comparison);
// Steps per second at 50 MHz next to other systems', and the share of the processor.
std::string to_svg(const Comparison& comparison);
std::string to_html(const Comparison& comparison);

}  // namespace benchmarks
