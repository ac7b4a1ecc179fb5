// SPDX-License-Identifier: Apache-2.0
// Searches and series of runs.
#include "tools/benchmark/stepping_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace benchmarks {

namespace {

constexpr std::uint32_t train_hertz = 10'000;
constexpr std::uint32_t train_baud = 1'000'000;
constexpr std::uint32_t fewest_clocks = 2;
// 100 000 ticks/s at 50 MHz, which every driver can do.
constexpr std::uint32_t driver_share_clocks = 500;
constexpr double to_the_clock = 0;

class Measurement {
 public:
  Measurement(const sim::ElfImage& program, const Scope& scope)
      : program_(program), scope_(scope) {}

  Run run(const Motion& motion, const Demand& demand = {}) const {
    return run_motion(program_, motion, scope_, demand);
  }

  LoopRates rates(std::size_t count, const DriverGuard& guard) const {
    const Motion in_lines{.ticks_per_line = scope_.quick ? 200u : 500u,
                          .lines = scope_.quick ? 10u : 40u,
                          .axes = count,
                          .guard = guard};
    const Motion in_one{.ticks_per_line = scope_.quick ? 2'000u : 20'000u,
                        .lines = 1,
                        .axes = count,
                        .guard = guard};
    return {count, guard, limits(in_lines), limits(in_one)};
  }

  JitterFigure jitter(double interval_clocks) const {
    const Motion motion{.interval_clocks = interval_clocks,
                        .ticks_per_line = 500,
                        .lines = scope_.quick ? 4u : 12u,
                        .axes = axes};
    return {interval_clocks, jitter_of(run(motion).pins[0].rises)};
  }

  Train train(bool saturated) const {
    const Motion motion{.interval_clocks = static_cast<double>(scope_.clock_hz) / train_hertz,
                        .ticks_per_line = 100,
                        .lines = scope_.quick ? 2u : 10u,
                        .baud = saturated ? train_baud : 0};
    const Jitter jitter = jitter_of(run(motion).pins[0].rises);
    return {saturated, scope_.clock_hz / jitter.mean, jitter};
  }

  Share share(std::uint32_t interval_clocks) const {
    // Twice what the hardware's queue holds, so that handing over counts for both.
    return share(Motion{.interval_clocks = static_cast<double>(interval_clocks),
                        .ticks_per_line = scope_.quick ? 10u : 50u,
                        .lines = 64,
                        .axes = axes});
  }

  DriverShare share(const DriverGuard& guard) const {
    return {guard, share(Motion{.interval_clocks = driver_share_clocks,
                                .ticks_per_line = scope_.quick ? 50u : 500u,
                                .lines = scope_.quick ? 10u : 40u,
                                .axes = axes,
                                .guard = guard})};
  }

 private:
  Share share(const Motion& motion) const {
    const Run result = run(motion);
    return {static_cast<std::uint32_t>(motion.interval_clocks), result.busy_share,
            result.clean(motion)};
  }

  Limits limits(Motion motion) const {
    const auto trial = [&](std::uint32_t clocks, double late_enough_clocks) -> Trial {
      motion.interval_clocks = clocks;
      const Run result = run(motion, {.clean = true, .latest_clocks = late_enough_clocks});
      // Such a run has not reached its end.
      if (result.largest_lateness_clocks > late_enough_clocks) {
        return {.fault = {}, .largest_lateness_clocks = result.largest_lateness_clocks};
      }
      return {std::string(result.fault(motion)), result.largest_lateness_clocks};
    };
    return RateSearch(trial, scope_.tolerance_clocks(), to_the_clock)
        .limits(std::max(fewest_clocks, motion.guard.shortest_interval()));
  }

  const sim::ElfImage& program_;
  const Scope& scope_;
};

}  // namespace

Figures measure(Stepping stepping, const sim::ElfImage& program, const Scope& scope,
                const std::function<void(const std::string&)>& say) {
  const Measurement measurement(program, scope);
  Figures figures;
  figures.stepping = stepping;
  // The most common drivers come first.
  std::vector<DriverGuard> guards(real_drivers.begin(), real_drivers.end());
  guards.push_back(no_driver);
  for (const std::size_t count : {std::size_t{1}, axes}) {
    for (const DriverGuard& guard : guards) {
      if (scope.quick && guard.high != no_driver.high && count == 1) continue;
      say(fmt::format("{}: highest rates, {} {}, {}", name_of(stepping), count,
                      count == 1 ? "axis" : "axes", guard.driver));
      const LoopRates& rates = figures.loops.emplace_back(measurement.rates(count, guard));
      say(fmt::format("  lines: {}; one line: {}", rates.lines.text(), rates.one_line.text()));
    }
  }
  say(fmt::format("{}: jitter", name_of(stepping)));
  std::vector<double> intervals{1000, 1234.5};
  if (stepping == Stepping::hardware) intervals.insert(intervals.end(), {2, 3.3});
  for (const double clocks : intervals) figures.jitter.push_back(measurement.jitter(clocks));
  for (const bool saturated : {false, true}) {
    say(fmt::format("{}: 10 kHz, serial line {}", name_of(stepping),
                    saturated ? "saturated" : "silent"));
    figures.trains.push_back(measurement.train(saturated));
  }
  say(fmt::format("{}: share of the processor", name_of(stepping)));
  const std::vector<std::uint32_t> shares =
      scope.quick ? std::vector<std::uint32_t>{5000, 1000}
                  : std::vector<std::uint32_t>{10'000, 5000, 2500, 1500, 1000, 700, 500, 400};
  for (const std::uint32_t clocks : shares) figures.shares.push_back(measurement.share(clocks));
  for (const DriverGuard& guard : guards) figures.driver_shares.push_back(measurement.share(guard));
  return figures;
}

}  // namespace benchmarks
