// SPDX-License-Identifier: Apache-2.0
// schedule.hpp has the formulas.
#include "tools/timing/rounds.hpp"

#include <algorithm>

namespace timing {

namespace {

using units::Task;

Clocks gap_of(const Load& load, Task task) { return *load.gaps[static_cast<std::size_t>(task)]; }

// Handed over in so many rounds at most.
std::uint64_t lines_in(std::uint64_t rounds, const Facts& facts) {
  return facts.waiting_lines + rounds * facts.lines_of_a_round;
}

}  // namespace

bool Load::is_whole() const {
  return pass && line && refill_without_line && gaps_are_bounded() &&
         std::ranges::all_of(tasks, [](const auto& bound) { return bound.has_value(); });
}

bool Load::gaps_are_bounded() const {
  return start && std::ranges::all_of(gaps, [](const auto& bound) { return bound.has_value(); });
}

Clocks bound_of(const Load& load, Task task) { return *load.tasks[static_cast<std::size_t>(task)]; }

Clocks longest_gap(const Load& load) { return std::max(*load.start, *std::ranges::max(load.gaps)); }

Clocks overhead(const Load& load) {
  return *load.start + bound_of(load, Task::motion) + gap_of(load, Task::motion) +
         gap_of(load, Task::refill) + bound_of(load, Task::rest) + gap_of(load, Task::rest);
}

bool may_wait(Task task, const Facts& facts) {
  return facts.allowances[static_cast<std::size_t>(task)] != 0;
}

std::uint64_t waits_in(std::uint64_t rounds, const Facts& facts, const Load& load) {
  const Clocks reached = facts.least_line_clocks * facts.lines_of_a_pass - facts.refill_margin;
  std::uint64_t waits = 0;
  Clocks in_hand = 0;
  const auto pass_time = [&in_hand](Clocks time) { in_hand -= std::min(in_hand, time); };
  for (; rounds > 0; --rounds) {
    for (const Task task : all_tasks) {
      if (!may_wait(task, facts)) continue;
      const Clocks allowance = facts.allowances[static_cast<std::size_t>(task)];
      if (in_hand < std::min(allowance + facts.refill_reserve, reached)) {
        ++waits;
        in_hand = reached;
      }
      pass_time(bound_of(load, task) + gap_of(load, task));
      if (application::ends_pass(task)) pass_time(overhead(load) + bound_of(load, Task::refill));
    }
  }
  return waits;
}

std::uint64_t put_off_in(std::uint64_t rounds, const Facts& facts, const Load& load) {
  const std::uint64_t waits = waits_in(rounds, facts, load);
  const std::uint64_t others = rounds * application::passes_of_a_round + waits;
  return (lines_in(rounds, facts) + others) / facts.lines_of_a_refill + waits;
}

Clocks time_of_rounds(std::uint64_t rounds, const Facts& facts, const Load& load) {
  Clocks work = 0;
  for (const Task task : all_tasks) {
    if (may_wait(task, facts)) work += bound_of(load, task) + gap_of(load, task);
  }
  const std::uint64_t most = facts.lines_of_a_refill;
  const Clocks full = overhead(load) + bound_of(load, Task::refill);
  const std::uint64_t lines = lines_in(rounds, facts);
  const std::uint64_t others =
      rounds * application::passes_of_a_round + waits_in(rounds, facts, load);
  Clocks longest = 0;
  for (std::uint64_t in_others = 0; in_others <= lines; ++in_others) {
    const Clocks of_others =
        std::min(others * (overhead(load) + *load.refill_without_line) + in_others * *load.line,
                 others * full);
    const std::uint64_t full_ones = (lines - in_others + others + most - 1) / most;
    longest = std::max(longest, of_others + full_ones * full);
  }
  return rounds * work + longest;
}

}  // namespace timing
