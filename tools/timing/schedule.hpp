// SPDX-License-Identifier: Apache-2.0
// Whether the main loop meets its deadlines at a clock and a baud rate: response times of a
// cooperative cyclic executive, from the bounds of its tasks.
//
// The loop begins a pass at t(k), in which each task runs once, in a fixed order; nothing preempts
// it, so all that a task waits for is blocking by the pass. With P the bound of a pass, B and E
// those from the beginning of a pass to the beginning and to the end of a task, and S the sleep
// after a pass, t(k+1) - t(k) <= P, or P + S where nothing wakes the loop.
//
// An event that comes right after its task has looked waits for the rest of the pass and for the
// next pass up to the task: it is served within P + E (Liu, Real-Time Systems, 2000, chapters 5
// and 8: cyclic executive, blocking by nonpreemptivity). Of what needs n looks the last is over
// within n P + E. From one run of a task to the end of its next are at most P + S + E.
//
// Bytes that wait (as Le Boudec, Thiran, Network Calculus, 2001, backlog bound): in any time t at
// most t / T + 1 bytes of the time T are completed. Where a pass brings no more than a look takes,
// at most those of P + E wait, or those that wake the loop and those of E; otherwise they pile up
// until the host waits for an answer.
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
  // From the beginning of a pass; where it has no bound, that of the pass counts.
  std::array<std::optional<Clocks>, units::task_count> begins{}, ends{};
  std::array<std::optional<Clocks>, units::task_count> tasks{};  // by themselves
  std::optional<Clocks> line;  // handed over, all its segments
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
  motion_watchdog,
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
  bool up_to_a_clock;  // holds up to one; all others hold from one on
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
