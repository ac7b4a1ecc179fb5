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
    : choices_(choices),
      seed_(choices.seed ? *choices.seed : any_seed()),
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

void ReplayCheck::say_what_was_not_compared(const replay::CheckResult& result) const {
  if (result.dropped > 0) {
    say("replay: interrupted: {} chosen intervals were not compared\n", result.dropped);
  } else if (result.replayed == 0 && !interrupt_requested()) {
    say("replay: no interval was compared: choose from 1 to {}\n", result.intervals);
  } else if (choices_.last < ReplayChoices().last && choices_.last > result.intervals) {
    say("replay: the print ended before interval {}\n", choices_.last);
  }
  if (result.without_end > 0) {
    say("replay: the last interval ended with the print: only its pins were compared\n");
  }
}

ReplayOutcome ReplayCheck::finish() {
  recorder_.finish(chip_.now());
  const sim::Clock recorded = recorder_.recorded_clocks();
  const replay::CheckResult result = check_.finish();
  say("replay: {} of {} intervals, {} of {} clocks, by the whole chip's netlist{}: {} differ\n",
      result.replayed, result.intervals, result.clocks, chip_.now(),
      choices_.count ? fmt::format(" (--replay-seed {})", seed_) : "", result.differences.size());
  if (recorded < chip_.now()) {
    say("replay: {} clocks could not be recorded\n", chip_.now() - recorded);
  }
  say_what_was_not_compared(result);
  for (std::size_t i = 0; i < std::min(most_shown, result.differences.size()); ++i) {
    const replay::Difference& difference = result.differences[i];
    say("replay: interval {}, clock {}: {}: model {}, netlist {}\n", difference.interval,
        difference.clock, difference.what, difference.recorded, difference.replayed);
  }
  if (!result.differences.empty()) return ReplayOutcome::different;
  if (result.dropped > 0) return ReplayOutcome::cut_short;
  return result.replayed > 0 ? ReplayOutcome::same : ReplayOutcome::none_compared;
}

}  // namespace command
