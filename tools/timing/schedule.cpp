// SPDX-License-Identifier: Apache-2.0
// Times are in thousandths of a clock, so that milliseconds are whole at any frequency.
#include "tools/timing/schedule.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drivers/uart.hpp"
#include "tools/timing/certificate.hpp"
#include "tools/timing/rounds.hpp"

namespace timing {

namespace {

using units::Task;

constexpr std::array<RequirementRow, requirement_count> rows{{
    {Task::serial_line, "a bit of the serial line takes 4 clocks", "clocks of 100 bits", false},
    {Task::serial_line, "received bytes fit into the FIFO", "bytes", true},
    {Task::commands, "a host's line has a sign of life within 2 s", "clocks", false},
    {Task::serial_line, "M112 stops", "clocks", false},
    {Task::faults, "the emergency stop's fault is noted", "clocks", false},
    {Task::planning, "a stop is settled", "clocks", false},
    {Task::motion, "motion's watchdog is fed", "clocks", false},
    {Task::refill, "each task keeps to its allowance", "clocks", true},
    {Task::refill, "the reserve lasts until a line is there", "clocks", true},
    {Task::refill, "a refill reaches each task's need", "clocks", true},
    {Task::refill, "a refill gains time", "clocks", true},
    {Task::refill, "the horizon is no less than the queue holds", "clocks", false},
    {Task::refill, "the queue holds what each task needs", "clocks", true},
    {Task::heat, "the heaters' watchdog is fed", "clocks", false},
    {Task::heat, "the heaters' watchdog is not fed too early", "clocks", false},
}};

constexpr Wide thousand = 1000;

// What holds at one rate.
class Situation {
 public:
  Situation(const Facts& facts, const Load& load, Rate rate)
      : facts_(facts), load_(load), rate_(rate) {}

  Response response(Requirement requirement) const;

 private:
  Wide bound(Task task) const { return thousand * bound_of(load_, task); }
  Wide pass() const { return thousand * *load_.pass; }
  Wide rounds(std::uint64_t number) const {
    return thousand * time_of_rounds(number, facts_, load_);
  }
  // From the moment after a look of the task: what needs so many looks.
  Wide served(Task task, std::uint64_t looks) const { return rounds(looks) + bound(task); }
  // As the firmware counts: a tick of its clock is a millisecond, or up to a clock less.
  Wide at_most(std::uint64_t ms) const { return Wide{ms} * rate_.clock_hz; }
  Wide at_least(std::uint64_t ms) const { return at_most(ms) - thousand * Wide{ms}; }
  Wide sleep() const { return at_most(facts_.sleep_ms); }
  // What the time in hand and the time of a look lose by being whole microseconds, and more.
  Wide rounding() const { return 3 * at_most(1) / 1000; }
  Wide time_of_bytes(std::uint64_t bytes) const {
    return (thousand * bytes * facts_.frame_bits * rate_.clock_hz + rate_.baud - 1) / rate_.baud;
  }

  Wide sign_of_life() const;
  Response allowances() const;
  Wide reserve() const;
  Wide margin() const;
  Wide in_hand() const;
  Wide heater_feed() const;
  Wide early_heater_feed() const;
  static Response within(Wide worst, Wide allowed);

  const Facts& facts_;
  const Load& load_;
  Rate rate_;
};

std::uint64_t clocks_above(Wide time) { return static_cast<std::uint64_t>((time + 999) / 1000); }

Response Situation::within(Wide worst, Wide allowed) {
  return {.worst = clocks_above(worst),
          .allowed = allowed < 0 ? 0 : static_cast<std::uint64_t>(allowed / thousand),
          .holds = worst <= allowed};
}

// It is taken in a look. From then on the busy message is due `busy_lead` before 2 s, which the
// next look finds, and given to the uart before that round ends.
Wide Situation::sign_of_life() const {
  return served(Task::serial_line, 1) + at_most(1) + rounds(2) + sleep() +
         time_of_bytes(facts_.busy_message_bytes);
}

// The task that takes the greatest part of its allowance.
Response Situation::allowances() const {
  Response greatest = within(0, thousand);
  for (const Task task : all_tasks) {
    const auto allowance = facts_.allowances[static_cast<std::size_t>(task)];
    if (allowance == 0) continue;
    const Response response = within(bound(task), thousand * allowance);
    if (Wide{*response.worst} * greatest.allowed > Wide{*greatest.worst} * response.allowed) {
      greatest = response;
    }
  }
  return greatest;
}

// What must be in hand where no task begins: each line must be there before those before it end.
// What is in hand is known as of the end of the task before, a gap ago.
Wide Situation::reserve() const {
  const Wide all = bound(Task::refill), one = thousand * *load_.line;
  Wide longest = 0;
  for (std::uint64_t line = 0; line < facts_.lines_of_a_refill; ++line) {
    const Wide there = std::min(all, thousand * *load_.refill_without_line + (line + 1) * one);
    longest = std::max(longest, there - thousand * line * facts_.least_line_clocks);
  }
  return rounding() + thousand * (longest_gap(load_) + overhead(load_)) + longest;
}

// How much less than what is due at the end of a refill is in hand when the next pass gets to a
// task, behind motion's turn: it may have seen that before a line that has filled the queue.
Wide Situation::margin() const {
  return rounding() + thousand * (overhead(load_) + *load_.refill_without_line + *load_.line);
}

// What a refill must make sure of, so that the longest of all may begin.
Wide Situation::in_hand() const {
  Wide longest = bound(Task::refill);
  for (const Task task : all_tasks) {
    if (may_wait(task, facts_)) longest = std::max(longest, bound(task));
  }
  return longest + thousand * (facts_.refill_reserve + facts_.refill_margin);
}

// The rounds of the heaters begin a period apart, but for a round of the loop and a sleep, and so
// does their last heater's turn; the second key comes at the end of that pass.
Wide Situation::heater_feed() const {
  return at_most(facts_.heat_period_ms + 1) + 2 * (rounds(1) + sleep()) + pass();
}

// From a first key that comes late in its task to the next that comes at once. The task itself
// looks how long ago the last one was.
Wide Situation::early_heater_feed() const {
  return at_least(facts_.least_heat_ms - 1) - bound(Task::heat);
}

Response Situation::response(Requirement requirement) const {
  constexpr std::uint64_t bits = 100;
  if (requirement == Requirement::bits) {
    const bool holds =
        drivers::Uart::increment(rate_.baud, units::Hertz(rate_.clock_hz)).has_value();
    return {.worst = bits * rate_.clock_hz / rate_.baud,
            .allowed = 4 * bits,
            .is_least = true,
            .holds = holds};
  }
  if (!load_.is_whole()) return {.worst = {}, .is_bounded = false};
  const Wide tick = thousand * facts_.heater_tick_clocks;
  switch (requirement) {
    case Requirement::received_bytes: {
      const std::uint64_t bytes = facts_.unanswered_lines * facts_.bytes_of_a_line;
      return {
          .worst = bytes, .allowed = facts_.receive_depth, .holds = bytes <= facts_.receive_depth};
    }
    case Requirement::sign_of_life:
      return within(sign_of_life(), at_most(facts_.busy_lead_ms));
    case Requirement::stop_by_host:
      return within(served(Task::serial_line, facts_.unanswered_lines),
                    at_most(facts_.stop_by_host_within_ms));
    case Requirement::emergency_stop:
      return within(served(Task::faults, 1), at_most(facts_.stop_within_ms));
    case Requirement::stop_settled:
      return within(served(Task::planning, 1), at_most(facts_.stop_within_ms));
    case Requirement::motion_watchdog:
      return within(pass() + sleep() + thousand * *load_.start + bound(Task::motion) + thousand,
                    at_least(facts_.motion_watchdog_ms));
    case Requirement::allowances:
      return allowances();
    case Requirement::reserve:
      return within(reserve(), thousand * facts_.refill_reserve);
    case Requirement::margin:
      return within(margin(), thousand * facts_.refill_margin);
    case Requirement::gain:
      return within(bound(Task::refill) + thousand * overhead(load_),
                    thousand * facts_.lines_of_a_refill * facts_.least_line_clocks);
    case Requirement::horizon:
      return within(thousand * facts_.least_line_clocks * facts_.lines_of_a_pass,
                    at_most(facts_.horizon_ms));
    case Requirement::queue:
      return within(in_hand(), thousand * facts_.least_line_clocks * facts_.lines_of_a_pass);
    case Requirement::heater_watchdog:
      return within(heater_feed() + thousand, at_most(facts_.heater_watchdog_ms) - 2 * tick);
    case Requirement::not_too_early: {
      const Wide least = at_most(facts_.heater_watchdog_ms) / facts_.early_part + tick;
      Response response = within(least, early_heater_feed());
      std::swap(*response.worst, response.allowed);
      response.is_least = true;
      return response;
    }
    case Requirement::bits:
    case Requirement::count:
      break;
  }
  return {};
}

// The first of [low, high] from which on it is so, or high + 1; it is so from some one on.
template <class Predicate>
std::uint32_t first_of(std::uint32_t low, std::uint32_t high, const Predicate& is_so) {
  ++high;
  while (low < high) {
    const std::uint32_t middle = low + (high - low) / 2;
    if (is_so(middle)) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return low;
}

}  // namespace

const RequirementRow& row_of(Requirement requirement) {
  return rows[static_cast<std::size_t>(requirement)];
}

std::string Response::text() const {
  const RequirementRow& row = row_of(requirement);
  if (!is_bounded) return fmt::format("{}: not bounded", row.name);
  return fmt::format("{}: {} {} {} {}", row.name, *worst, is_least ? "where it must be" : "of",
                     allowed, row.unit);
}

Response respond(Requirement requirement, const Facts& facts, const Load& load, Rate rate) {
  Response response = Situation(facts, load, rate).response(requirement);
  response.requirement = requirement;
  return response;
}

std::vector<Response> respond(const Facts& facts, const Load& load, Rate rate) {
  std::vector<Response> responses;
  for (std::size_t i = 0; i < requirement_count; ++i) {
    responses.push_back(respond(static_cast<Requirement>(i), facts, load, rate));
  }
  return responses;
}

ClockRange clocks_that_hold(const Facts& facts, const Load& load, std::uint32_t baud) {
  ClockRange range{.lowest_hz = slowest_clock_hz, .highest_hz = fastest_clock_hz};
  for (std::size_t i = 0; i < requirement_count; ++i) {
    const auto requirement = static_cast<Requirement>(i);
    const auto at = [&](std::uint32_t clock_hz) {
      return respond(requirement, facts, load, {clock_hz, baud});
    };
    if (!at(slowest_clock_hz).is_bounded) continue;
    if (row_of(requirement).up_to_a_clock) {
      const std::uint32_t first = first_of(slowest_clock_hz, fastest_clock_hz,
                                           [&](std::uint32_t hz) { return !at(hz).holds; });
      if (first - 1 >= range.highest_hz) continue;
      range.highest_hz = first - 1;
      range.faster_fails = requirement;
    } else {
      const std::uint32_t first = first_of(slowest_clock_hz, fastest_clock_hz,
                                           [&](std::uint32_t hz) { return at(hz).holds; });
      if (first <= range.lowest_hz) continue;
      range.lowest_hz = first;
      range.slower_fails = requirement;
    }
  }
  return range;
}

}  // namespace timing
