// SPDX-License-Identifier: Apache-2.0
// G-code in at the serial line, pins out; the heaters are hot and controlled meanwhile.
#include "tools/benchmark/printing_run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <span>

#include "sim/machine/printer.hpp"
#include "sim/simulation/simulation.hpp"
#include "sim/simulation/verilated_chip.hpp"
#include "tools/benchmark/lateness.hpp"
#include "tools/benchmark/window_host.hpp"

namespace benchmarks {

namespace {

// Of firmware/machines/benchmark.toml: X leads, so its limits are those of the ticks.
constexpr double steps_per_mm = 10'000;
constexpr double most_acceleration_mm_s2 = 50'000;
constexpr double least_ramp_ticks = 5'000;
constexpr double hotend_c = 205;
constexpr double bed_c = 60;
// Time until the temperatures are known and controlled, before the lines come.
constexpr unsigned settle_ms = 250;
constexpr sim::Clock start_clocks = 30'000'000;
constexpr sim::Clock looks_clocks = 20'000;
constexpr sim::Clock after_end_clocks = 1'000;
// Words of software_stepping::Counters.
constexpr std::uint32_t underruns_word = 1;
constexpr std::uint32_t late_ticks_word = 3;
constexpr std::uint32_t delay_clocks_word = 4;
// Rates are rounded to um/s and to the segments' format; a planner that cannot keep up is far off.
constexpr double rate_tolerance = 0.001;

// In percent, so that each line has whole steps of all.
constexpr std::array<std::uint32_t, axes> parts_percent{100, 83, 61, 37};

std::array<std::uint32_t, axes> steps_of(const Printing& printing) {
  std::array<std::uint32_t, axes> steps{};
  for (std::size_t i = 0; i < printing.axes; ++i) {
    steps[i] = printing.ticks_per_line / 100 * parts_percent[i];
  }
  return steps;
}

// Feed rates count along X, Y and Z: how much longer that way is than X alone.
double length_per_x(const Printing& printing) {
  double squares = 0;
  for (std::size_t i = 0; i < std::min<std::size_t>(printing.axes, 3); ++i) {
    squares += std::pow(parts_percent[i] / 100.0, 2);
  }
  return std::sqrt(squares);
}

std::vector<std::string> lines_of(const Printing& printing, std::uint32_t clock_hz) {
  const double way = length_per_x(printing);
  const double mm_s = way * clock_hz / printing.interval_clocks / steps_per_mm;
  const double mm_s2 =
      way * Printing::acceleration_hz_per_s(printing.interval_clocks, clock_hz) / steps_per_mm;
  std::vector<std::string> lines{fmt::format("M104 S{}", hotend_c),
                                 fmt::format("M140 S{}", bed_c),
                                 "G91",
                                 "M83",
                                 "M17",
                                 fmt::format("G4 P{}", settle_ms),
                                 fmt::format("M204 P{0:.3f} T{0:.3f}", mm_s2),
                                 fmt::format("G1 F{:.3f}", mm_s * 60)};
  std::string line = "G1";
  const auto steps = steps_of(printing);
  for (std::size_t i = 0; i < printing.axes; ++i) {
    line += fmt::format(" {}{:.4f}", "XYZE"[i], steps[i] / steps_per_mm);
  }
  lines.insert(lines.end(), printing.lines, line);
  lines.push_back("M400");
  return lines;
}

class Counters {
 public:
  Counters(const sim::ElfImage& firmware, const sim::Chip& chip)
      : chip_(chip), stepper_(firmware.symbol("software_stepping_counters")) {}

  void read(PrintingRun& run) const {
    if (stepper_) {
      run.underruns = word(underruns_word);
      run.late_ticks = word(late_ticks_word);
      run.delay_clocks = word(delay_clocks_word);
    } else {
      const sim::QueueStatistics queue = chip_.queue_statistics();
      run.underruns = queue.underruns;
      run.delay_clocks = queue.guard_stall_clocks;
    }
  }

 private:
  std::uint64_t word(std::uint32_t index) const { return chip_.read_memory(*stepper_ + 4 * index); }

  const sim::Chip& chip_;
  std::optional<std::uint32_t> stepper_;  // address, where software makes the steps
};

// The middle half.
std::span<const sim::Clock> middle_half(std::span<const sim::Clock> rises) {
  const std::size_t first = rises.size() / 4;
  const std::size_t last = rises.size() * 3 / 4;
  return rises.size() < 8 ? std::span<const sim::Clock>() : rises.subspan(first, last - first + 1);
}

double mean_interval(std::span<const sim::Clock> rises) {
  if (rises.size() < 2) return 0;
  return static_cast<double>(rises.back() - rises.front()) / static_cast<double>(rises.size() - 1);
}

}  // namespace

double Printing::acceleration_hz_per_s(double interval_clocks, std::uint32_t clock_hz) {
  const double rate_hz = clock_hz / interval_clocks;
  return std::min(rate_hz * rate_hz / (2 * least_ramp_ticks),
                  most_acceleration_mm_s2 * steps_per_mm);
}

std::uint32_t Printing::ramp_ticks(double interval_clocks, std::uint32_t clock_hz) {
  const double rate_hz = clock_hz / interval_clocks;
  const double acceleration = acceleration_hz_per_s(interval_clocks, clock_hz);
  return static_cast<std::uint32_t>(std::ceil(rate_hz * rate_hz / (2 * acceleration)));
}

std::string_view PrintingRun::fault(const Printing& printing) const {
  if (!complaint.empty()) return "a line was refused";
  if (late_ticks != 0) return "ticks late";
  if (underruns != 0) return "queue empty at speed";
  if (delay_clocks != 0) return "ticks delayed";
  if (!ended) return "not finished";
  for (std::size_t i = 0; i < axes; ++i) {
    if (pins[i].rises.size() != asked[i]) return "pulses missing";
  }
  // Any pulse that is seen keeps a guard of one clock.
  if (middle_interval_clocks > printing.interval_clocks * (1 + rate_tolerance)) {
    return "rate not reached";
  }
  return {};
}

PrintingRun run_printing(const sim::ElfImage& firmware, const machine::Description& description,
                         const Printing& printing, const Scope& scope, bool until_unclean) {
  sim::VerilatedChip chip(scope.clock_hz);
  if (firmware.symbol("software_stepping_counters")) chip.permit_software_stepping();
  sim::load(firmware, chip);
  sim::Simulation simulation(chip, sim::ClockRate(scope.clock_hz));
  machine::Printer printer(
      description,
      {.baud = description.baud, .hotend_start_c = hotend_c, .bed_start_c = bed_c, .faults = {}},
      simulation);
  PinWatch watch;
  simulation.attach(watch, PinWatch::watched());
  WindowHost host(lines_of(printing, scope.clock_hz), printer.serial_line());
  const Counters counters(firmware, chip);

  PrintingRun run;
  // Ramps take twice as long as the same distance at full speed.
  const double motion_clocks =
      4 * printing.interval_clocks * printing.ticks_per_line * printing.lines;
  const auto limit = static_cast<sim::Clock>(motion_clocks) + start_clocks;
  while (!host.done() && simulation.now() < limit) {
    scope.look();
    simulation.run_until(simulation.now() + looks_clocks);
    counters.read(run);
    if (!host.complaint().empty()) break;
    if (until_unclean && run.late_ticks + run.delay_clocks + run.underruns != 0) break;
  }
  run.ended = host.done();
  run.complaint = host.complaint();
  simulation.run_until(simulation.now() + after_end_clocks);
  counters.read(run);
  const auto steps = steps_of(printing);
  for (std::size_t i = 0; i < axes; ++i) {
    run.pins[i] = watch.axis(i);
    run.asked[i] = std::uint64_t{steps[i]} * printing.lines;
  }
  run.middle_interval_clocks = mean_interval(middle_half(run.pins[0].rises));
  const std::vector<sim::Clock> ticks = ticks_of(run.pins);
  run.largest_lateness_clocks = largest_lateness_in_even_series(middle_half(ticks));
  return run;
}

}  // namespace benchmarks
