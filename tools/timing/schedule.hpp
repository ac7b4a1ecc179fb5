// SPDX-License-Identifier: Apache-2.0
// Whether the main loop meets its deadlines at a clock and a baud rate: response times of a
// cooperative cyclic executive, from the bounds of its tasks.
//
// A round runs each task once, in a fixed order; nothing preempts it, so all that a task waits for
// is blocking by the round (Liu, Real-Time Systems, 2000, chapters 5 and 8: cyclic executive,
// blocking by nonpreemptivity). While motion needs lines a task is put off until more is in hand
// than its need. Then the pass refills and ends, and the next one goes on with that task: a round
// takes some passes.
//
// Motion never ends before its next line is there. What is in hand when a task begins outlasts its
// allowance and the reserve, and a refill of several lines gains more time than it and the rest of
// a pass take.
//
// Each task has its turn. A refill ends with the most lines that a pass hands over, or with all
// that is due. When the pass behind it gets to the task, what is due has become less by a line that
// has filled the queue and the overhead of a pass, which is within the margin, and no need is
// closer to what is due than that. So a refill after which the task waits again is full: it has
// begun the most lines; and no more lines are begun than wait in the planner's ring and come into
// it meanwhile. All others are behind a whole round, or the last before their task begins: these
// are no more than with tasks that begin with just what a refill makes sure of, and take their
// bounds. In n rounds, with the bounds of tasks B, the gaps behind them g, the overhead of a pass
// O, a refill R, one without a line r, each line l,
//
//   lines <= ring + n appended,  others <= n passes of a round + waits of n rounds,
//   T(n) = n (sum of B + g) + the greatest, for k lines in all of the others, of
//          others (O + r) + k l, or others (O + R), + (lines - k + others) / most lines (O + R),
//
// where a line that has filled the queue in one of the others is finished in a full one.
//
// An event right after its task has looked is served within T(1) + B, and what needs n looks
// within T(n) + B.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "application/task_table.hpp"
#include "tools/timing/network.hpp"

namespace timing {

using Facts = application::ScheduleFacts;

// Bounds of an image; nothing where there is none.
struct Load {
  std::optional<Clocks> pass;
  std::array<std::optional<Clocks>, units::task_count> tasks{};
  // From the beginning of a pass, or the end of a task, to the next beginning of one, or the end of
  // the pass.
  std::optional<Clocks> start;
  std::array<std::optional<Clocks>, units::task_count> gaps{};
  std::optional<Clocks> line;  // handed over, all its segments
  std::optional<Clocks> refill_without_line;  // but for what is left of one

  // Nothing without a bound.
  bool is_whole() const;
  bool gaps_are_bounded() const;
};

struct Rate {
  std::uint32_t clock_hz{}, baud{};
};

enum class Requirement : std::uint8_t {
  bits,
  received_bytes,
  sign_of_life,
  stop_by_host,
  emergency_stop,
  stop_settled,
  motion_watchdog,
  allowances,
  reserve,
  margin,
  gain,
  horizon,
  queue,
  heater_watchdog,
  not_too_early,
  count
};
inline constexpr std::size_t requirement_count = static_cast<std::size_t>(Requirement::count);

struct RequirementRow {
  units::Task task;
  const char* name;
  const char* unit;
  bool up_to_a_clock;  // holds up to one, or at all; all others hold from one on
};
const RequirementRow& row_of(Requirement requirement);

// What it comes to in the worst case, and what is allowed: clocks, bytes.
struct Response {
  Requirement requirement{};
  std::optional<std::uint64_t> worst;  // none: the bound is missing, or there is no end to it
  std::uint64_t allowed{};
  bool is_least{};  // worst must not be below it
  bool is_bounded = true;
  bool holds{};

  // "motion's watchdog is fed: 1234 of 800000 clocks".
  std::string text() const;
};

Response respond(Requirement requirement, const Facts& facts, const Load& load, Rate rate);
std::vector<Response> respond(const Facts& facts, const Load& load, Rate rate);

inline constexpr std::uint32_t slowest_clock_hz = 100'000, fastest_clock_hz = 1'000'000'000;

// The clocks at which all requirements hold.
struct ClockRange {
  std::uint32_t lowest_hz{}, highest_hz{};
  // Why none is slower, and none faster: absent at the ends of what is tried.
  std::optional<Requirement> slower_fails{}, faster_fails{};

  bool is_empty() const { return lowest_hz > highest_hz; }
};

// Exact, by search over respond(). Without requirements whose bounds are missing.
ClockRange clocks_that_hold(const Facts& facts, const Load& load, std::uint32_t baud);

}  // namespace timing
