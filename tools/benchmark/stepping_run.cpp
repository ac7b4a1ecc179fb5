// SPDX-License-Identifier: Apache-2.0
// The workload is written into the chip's memory before it starts, and the result is read
// from there.
#include "tools/benchmark/stepping_run.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "sim/devices/serial_line.hpp"
#include "sim/simulation/simulation.hpp"
#include "sim/simulation/verilated_chip.hpp"
#include "tools/benchmark/lateness.hpp"

namespace benchmarks {

namespace {

using Order = benchmark::SteppingOrder;
using Result = benchmark::SteppingResult;
using OrderWords = std::array<std::uint32_t, sizeof(Order) / 4>;
using ResultWords = std::array<std::uint32_t, sizeof(Result) / 4>;

constexpr sim::Clock start_clocks = 200'000;
constexpr sim::Clock looks_clocks = 20'000;
// Word of software_stepping::Counters.
constexpr std::uint32_t late_ticks_word = 3;

// Steps of each axis in a line: parts that make Bresenham work.
std::array<std::uint32_t, axes> steps_of(const Motion& motion) {
  constexpr std::array<double, axes> parts{1.0, 0.83, 0.61, 0.37};
  std::array<std::uint32_t, axes> steps{};
  for (std::size_t i = 0; i < motion.axes; ++i) {
    steps[i] = static_cast<std::uint32_t>(motion.ticks_per_line * parts[i]);
  }
  return steps;
}

Order order_of(const Motion& motion) {
  const auto rate = static_cast<std::uint64_t>(std::ldexp(1.0L / motion.interval_clocks, 64));
  Order order;
  order.guard_high = motion.guard.high;
  order.guard_low = motion.guard.low;
  order.guard_setup = motion.guard.setup;
  order.guard_hold = motion.guard.hold;
  order.baud = motion.baud;
  // A quarter of the time that eight lines take; the shorter queue holds eight.
  const double queue_clocks = 8 * motion.interval_clocks * motion.ticks_per_line;
  order.wake_clocks = static_cast<std::uint32_t>(std::clamp(queue_clocks / 4, 500.0, 400'000.0));
  order.piece_count = motion.lines == 1 ? 1 : 2;
  order.repetitions = motion.lines / order.piece_count;
  const auto steps = steps_of(motion);
  for (std::uint32_t way = 0; way < order.piece_count; ++way) {
    benchmark::Piece& piece = order.pieces[way];
    for (std::size_t i = 0; i < axes; ++i) {
      const auto forward = static_cast<std::int32_t>(steps[i]);
      piece.steps[i] = way == 0 ? forward : -forward;
    }
    piece.line_ticks = piece.ticks = motion.ticks_per_line;
    piece.rate_low = static_cast<std::uint32_t>(rate);
    piece.rate_high = static_cast<std::uint32_t>(rate >> 32);
  }
  return order;
}

std::uint32_t address_of(const sim::ElfImage& program, const char* symbol) {
  const auto address = program.symbol(symbol);
  if (!address) throw std::runtime_error(std::string("the benchmark's program has no ") + symbol);
  return *address;
}

Result read_result(const sim::ElfImage& program, const sim::Chip& chip) {
  const std::uint32_t address = address_of(program, "benchmark_result");
  ResultWords words{};
  for (std::uint32_t i = 0; i < words.size(); ++i) words[i] = chip.read_memory(address + 4 * i);
  return std::bit_cast<Result>(words);
}

std::uint32_t late_ticks(const sim::ElfImage& program, const sim::Chip& chip) {
  const auto counters = program.symbol("software_stepping_counters");
  return counters ? chip.read_memory(*counters + 4 * late_ticks_word) : 0;
}

bool enough(sim::Clock shortest, std::uint32_t least) {
  return shortest == sim::never || shortest >= least;
}

}  // namespace

std::string_view Run::fault(const Motion& motion) const {
  if (late_ticks != 0) return "ticks late";
  if (result.underruns != 0) return "queue empty at speed";
  if (result.stall_clocks != 0) return "ticks delayed";
  if (result.refused != 0) return "a segment was refused";
  if (result.bytes_lost != 0) return "bytes lost";
  if (!ended) return "not finished";
  for (std::size_t i = 0; i < axes; ++i) {
    if (pins[i].rises.size() != asked[i]) return "pulses missing";
    const DriverGuard& guard = motion.guard;
    if (!enough(pins[i].shortest_high, guard.high) || !enough(pins[i].shortest_low, guard.low) ||
        !enough(pins[i].shortest_setup, guard.setup) ||
        !enough(pins[i].shortest_hold, guard.hold)) {
      return "guard not kept";
    }
  }
  // By the pins, whatever the program counts.
  if (largest_lateness_clocks >= motion.interval_clocks) return "ticks late";
  return {};
}

void load_motion(const sim::ElfImage& program, const Motion& motion, sim::VerilatedChip& chip) {
  if (program.symbol("software_stepping_counters")) chip.permit_software_stepping();
  sim::load(program, chip);
  const auto words = std::bit_cast<OrderWords>(order_of(motion));
  const std::uint32_t address = address_of(program, "benchmark_order");
  for (std::uint32_t i = 0; i < words.size(); ++i) chip.write_memory(address + 4 * i, words[i]);
}

Run run_motion(const sim::ElfImage& program, const Motion& motion, const Scope& scope,
               const Demand& demand) {
  sim::VerilatedChip chip(scope.clock_hz);
  load_motion(program, motion, chip);

  const sim::ClockRate rate(scope.clock_hz);
  sim::Simulation simulation(chip, rate);
  PinWatch watch;
  simulation.attach(watch, PinWatch::watched());
  const double duration = motion.interval_clocks * motion.ticks_per_line * motion.lines;
  std::optional<devices::SerialLine> line;
  if (motion.baud != 0) {
    line.emplace(rate, motion.baud, chip.inputs());
    simulation.attach(*line, sim::OutputPins::transmit_pin());
    const double bytes = (duration + start_clocks) / rate.hertz() * motion.baud / 10;
    line->send(0, std::string(static_cast<std::size_t>(bytes), 'U'));
  }

  Run run;
  const auto limit = static_cast<sim::Clock>(4 * duration) + start_clocks;
  sim::ProcessorStatistics before;
  sim::Clock first = 0;
  RunningLateness lateness(motion.interval_clocks);
  while (!run.ended && simulation.now() < limit) {
    scope.look();
    simulation.run_until(simulation.now() + looks_clocks);
    const bool moves = !watch.axis(0).rises.empty();
    if (moves && first == 0) {
      first = simulation.now();
      before = chip.processor_statistics();
    }
    run.late_ticks = late_ticks(program, chip);
    lateness.add(watch.axis(0).rises);
    if ((demand.clean && run.late_ticks != 0) || lateness.clocks() > demand.latest_clocks) break;
    run.ended = read_result(program, chip).done != 0;
    if (!run.ended && simulation.now() > first && first != 0) {
      const auto slept = chip.processor_statistics().sleeping_clocks - before.sleeping_clocks;
      run.busy_share =
          1 - static_cast<double>(slept) / static_cast<double>(simulation.now() - first);
    }
  }
  run.result = read_result(program, chip);
  const auto steps = steps_of(motion);
  for (std::size_t i = 0; i < axes; ++i) {
    run.pins[i] = watch.axis(i);
    run.asked[i] = std::uint64_t{steps[i]} * motion.lines;
  }
  run.largest_lateness_clocks = largest_lateness(ticks_of(run.pins), motion.interval_clocks);
  return run;
}

Jitter jitter_of(const std::vector<sim::Clock>& rises) {
  Jitter jitter;
  if (rises.size() < 2) return jitter;
  jitter.intervals = rises.size() - 1;
  jitter.shortest = sim::never;
  jitter.mean =
      static_cast<double>(rises.back() - rises.front()) / static_cast<double>(jitter.intervals);
  double squares = 0;
  for (std::size_t i = 1; i < rises.size(); ++i) {
    const sim::Clock interval = rises[i] - rises[i - 1];
    jitter.shortest = std::min(jitter.shortest, interval);
    jitter.longest = std::max(jitter.longest, interval);
    squares += std::pow(static_cast<double>(interval) - jitter.mean, 2);
  }
  jitter.standard_deviation = std::sqrt(squares / static_cast<double>(jitter.intervals));
  return jitter;
}

}  // namespace benchmarks
