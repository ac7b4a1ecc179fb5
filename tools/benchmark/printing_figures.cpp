// SPDX-License-Identifier: Apache-2.0
// The search for the feed rate.
#include "tools/benchmark/printing_figures.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace benchmarks {

namespace {

constexpr std::uint32_t cruise_ticks = 10'000;
// Ticks of a line are whole hundreds, so that all axes have whole steps.
constexpr std::uint32_t hundred = 100;
// Relative precision of the search for an interval: a run takes seconds.
constexpr double fine = 1.0 / 50, coarse = 1.0 / 8;

// `printing_at` gives what to print at an interval; `start` is the interval that the bare stepping
// loop reaches.
template <class PrintingAt>
Limits limits_of(const PrintingFirmware& firmware, const Scope& scope, std::uint32_t start,
                 PrintingAt printing_at) {
  // A print's lateness is known at its end.
  const auto run = [&](std::uint32_t clocks, double) -> Trial {
    const Printing printing = printing_at(clocks);
    const PrintingRun result =
        run_printing(firmware.image, firmware.description, printing, scope, true);
    if (!result.complaint.empty()) return {result.complaint, 0};
    return {std::string(result.fault(printing)), result.largest_lateness_clocks};
  };
  return RateSearch(run, scope.tolerance_clocks(), scope.quick ? coarse : fine).limits(start);
}

}  // namespace

std::vector<PrintingRates> measure_printing(const Figures& bare, const PrintingFirmware& firmware,
                                            const Scope& scope,
                                            const std::function<void(const std::string&)>& say) {
  std::vector<PrintingRates> rates;
  for (const LoopRates& loop : bare.loops) {
    if (loop.guard.high != no_driver.high || (scope.quick && loop.axes != 1)) continue;
    say(fmt::format("{}: highest rates, the whole firmware, {} {}", name_of(bare.stepping),
                    loop.axes, loop.axes == 1 ? "axis" : "axes"));
    PrintingRates& figure = rates.emplace_back(loop.axes);
    const auto limits = [&](const Limits& of_loop, auto printing_at) {
      return limits_of(firmware, scope, of_loop.clean.interval_clocks, printing_at);
    };
    figure.lines = limits(loop.lines, [&](std::uint32_t clocks) {
      return Printing{.interval_clocks = static_cast<double>(clocks),
                      .ticks_per_line = 500,
                      .lines = 56,
                      .axes = loop.axes};
    });
    figure.one_line = limits(loop.one_line, [&](std::uint32_t clocks) {
      const std::uint32_t ramp = Printing::ramp_ticks(clocks, scope.clock_hz);
      // Both ramps within the outer quarters.
      const std::uint32_t ticks = std::max(2 * ramp + cruise_ticks, 4 * ramp + hundred);
      return Printing{.interval_clocks = static_cast<double>(clocks),
                      .ticks_per_line = (ticks + hundred - 1) / hundred * hundred,
                      .lines = 1,
                      .axes = loop.axes};
    });
    say(fmt::format("  lines: {}; one line: {}", figure.lines.text(), figure.one_line.text()));
  }
  return rates;
}

}  // namespace benchmarks
