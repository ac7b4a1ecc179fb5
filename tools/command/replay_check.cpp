// SPDX-License-Identifier: Apache-2.0
// Recorder, threads and messages.
#include "tools/command/replay_check.hpp"

#include <algorithm>
#include <random>
#include <thread>

#include "sim/replay/netlist_replay.hpp"
#include "tools/command/output.hpp"
#include "tools/command/signals.hpp"

namespace command {

namespace {

constexpr sim::Clock interval_clocks = 1'000'000;
constexpr std::size_t most_shown = 10;

std::uint64_t any_seed() {
  std::random_device device;
  return device();
}

replay::CheckPlan plan_of(const ReplayChoices& choices, std::uint64_t seed) {
  return {.count = choices.count,
          .first = choices.first,
          .last = choices.last,
          .seed = seed,
          .threads = std::max(1U, std::thread::hardware_concurrency()),
          .cancelled = interrupt_requested};
}

}  // namespace

ReplayCheck::ReplayCheck(const ReplayChoices& choices, const PrinterChoices& printer,
                         sim::VerilatedChip& chip)
    : seed_(choices.seed ? *choices.seed : any_seed()),
      at_random_(choices.count.has_value()),
      chip_(chip),
      check_(plan_of(choices, seed_),
             [clock_hz = printer.clock_hz,
              edges = choices.every_clock ? sim::Edges::all : sim::Edges::leaping] {
               constexpr bool software_stepping = false;  // Refused with --replay.
               return replay::make_netlist_replay(clock_hz, software_stepping, edges);
             }),
      recorder_(interval_clocks,
                [this](replay::Interval&& interval) { check_.take(std::move(interval)); }) {
  chip_.record(recorder_);
}

bool ReplayCheck::finish() {
  recorder_.finish(chip_.now());
  const sim::Clock recorded = recorder_.recorded_clocks();
  const replay::CheckResult result = check_.finish();
  say("replay: {} of {} intervals, {} of {} clocks, by the whole chip's netlist{}: {} differ\n",
      result.replayed, result.intervals, result.clocks, chip_.now(),
      at_random_ ? fmt::format(" (--replay-seed {})", seed_) : "", result.differences.size());
  if (recorded < chip_.now()) {
    say("replay: {} clocks could not be recorded\n", chip_.now() - recorded);
  }
  if (result.replayed == 0) {
    say("replay: no interval was compared: choose from 1 to {}\n", result.intervals);
  }
  for (std::size_t i = 0; i < std::min(most_shown, result.differences.size()); ++i) {
    const replay::Difference& difference = result.differences[i];
    say("replay: interval {}, clock {}: {}: model {}, netlist {}\n", difference.interval,
        difference.clock, difference.what, difference.recorded, difference.replayed);
  }
  return result.differences.empty() && result.replayed > 0;
}

}  // namespace command
