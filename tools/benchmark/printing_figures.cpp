// SPDX-License-Identifier: Apache-2.0
// Bisection of the feed rate.
#include "tools/benchmark/printing_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace benchmarks {

namespace {

constexpr std::uint32_t cruise_ticks = 10'000;
// Ticks of a line are whole hundreds, so that all axes have whole steps.
constexpr std::uint32_t hundred = 100;
// To which part of itself an interval is searched: a run takes seconds.
constexpr std::uint32_t fine_part = 50, coarse_part = 8;
// 500 steps/s at 50 MHz: whoever cannot do that has another fault.
constexpr std::uint32_t longest_interval = 100'000;

class Search {
 public:
  Search(const PrintingFirmware& firmware, const Scope& scope)
      : firmware_(firmware), clock_hz_(scope.clock_hz), coarse_(scope.quick) {}

  // `printing_at` tells what to print at an interval; `start` is what whoever makes the steps can
  // do with nothing else to do. Longer intervals than the answer are taken to be clean where the
  // next one tried is: what the firmware does besides may hit a tick or not.
  template <class PrintingAt>
  PrintingLimit limit(std::uint32_t start, PrintingAt printing_at) const {
    PrintingLimit result;
    const auto clean = [&](std::uint32_t clocks) {
      const Printing printing = printing_at(clocks);
      const PrintingRun run =
          run_printing(firmware_.image, firmware_.description, printing, clock_hz_, true);
      if (run.clean(printing)) return true;
      result.limited_by = run.complaint.empty() ? run.fault(printing) : run.complaint;
      return false;
    };
    std::uint32_t dirty = start - 1;
    std::uint32_t good = start;
    for (;;) {
      for (std::uint32_t more = good / 4 + 1; !clean(good); more *= 2) {
        dirty = good;
        good += more;
        if (good > longest_interval) {
          throw std::runtime_error("no rate is clean: " + result.limited_by);
        }
      }
      while (good - dirty > good / (coarse_ ? coarse_part : fine_part) + 1) {
        const std::uint32_t middle = dirty + (good - dirty) / 2;
        (clean(middle) ? good : dirty) = middle;
      }
      const std::uint32_t next = good + good / 50 + 1;
      if (good == start || clean(next)) break;
      dirty = next;
      good = next + 1;
    }
    result.interval_clocks = good;
    return result;
  }

 private:
  const PrintingFirmware& firmware_;
  std::uint32_t clock_hz_;
  bool coarse_;
};

}  // namespace

std::vector<PrintingRates> measure_printing(const Figures& bare, const PrintingFirmware& firmware,
                                            const Scope& scope,
                                            const std::function<void(const std::string&)>& say) {
  const Search search(firmware, scope);
  std::vector<PrintingRates> rates;
  for (const CleanRate& loop : bare.clean) {
    if (loop.guard_clocks != 1 || (scope.quick && loop.axes != 1)) continue;
    say(fmt::format("{}: highest clean rate, the whole firmware, {} {}", name_of(bare.stepping),
                    loop.axes, loop.axes == 1 ? "axis" : "axes"));
    PrintingRates& figure = rates.emplace_back(loop.axes);
    figure.lines = search.limit(loop.lines_clocks, [&](std::uint32_t clocks) {
      return Printing{.interval_clocks = static_cast<double>(clocks),
                      .ticks_per_line = 500,
                      .lines = 56,
                      .axes = loop.axes};
    });
    figure.one_line = search.limit(loop.one_line_clocks, [&](std::uint32_t clocks) {
      const std::uint32_t ramp = Printing::ramp_ticks(clocks, scope.clock_hz);
      // Both ramps within the outer quarters.
      const std::uint32_t ticks = std::max(2 * ramp + cruise_ticks, 4 * ramp + hundred);
      return Printing{.interval_clocks = static_cast<double>(clocks),
                      .ticks_per_line = (ticks + hundred - 1) / hundred * hundred,
                      .lines = 1,
                      .axes = loop.axes};
    });
  }
  return rates;
}

}  // namespace benchmarks
