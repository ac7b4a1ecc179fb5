// SPDX-License-Identifier: Apache-2.0
// Times are in thousandths of a clock, so that milliseconds are whole at any frequency.
#include "tools/timing/schedule.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drivers/uart.hpp"
#include "tools/timing/certificate.hpp"

namespace timing {

namespace {

using units::Task;

constexpr std::array<RequirementRow, requirement_count> rows{{
    {Task::serial_line, "a bit of the serial line takes 4 clocks", "clocks of 100 bits", false},
    {Task::serial_line, "received bytes fit into the FIFO", "bytes", false},
    {Task::commands, "a host's line has a sign of life within 2 s", "clocks", false},
    {Task::serial_line, "M112 stops", "clocks", false},
    {Task::faults, "the emergency stop's fault is noted", "clocks", false},
    {Task::motion, "motion's watchdog is fed", "clocks", false},
    {Task::refill, "motion goes on within the horizon", "clocks", false},
    {Task::refill, "motion goes on within what the queue holds", "clocks", true},
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
  Wide pass() const { return thousand * *load_.pass; }
  Wide within_pass(const std::array<std::optional<Clocks>, units::task_count>& bounds,
                   Task task) const {
    return thousand *
           std::min(bounds[static_cast<std::size_t>(task)].value_or(*load_.pass), *load_.pass);
  }
  Wide begin(Task task) const { return within_pass(load_.begins, task); }
  Wide end(Task task) const { return within_pass(load_.ends, task); }
  // As the firmware counts: a tick of its clock is a millisecond, or up to a clock less.
  Wide at_most(std::uint64_t ms) const { return Wide{ms} * rate_.clock_hz; }
  Wide at_least(std::uint64_t ms) const { return at_most(ms) - thousand * Wide{ms}; }
  Wide sleep() const { return at_most(facts_.sleep_ms); }

  // Bytes that are completed in a time, at most.
  std::uint64_t bytes_in(Wide time) const {
    const Wide bits = time * rate_.baud * facts_.fast_sender_percent / rate_.clock_hz;
    return static_cast<std::uint64_t>(bits / (thousand * 100 * facts_.frame_bits)) + 1;
  }
  Wide time_of_bytes(std::uint64_t bytes) const {
    return (thousand * bytes * facts_.frame_bits * rate_.clock_hz + rate_.baud - 1) / rate_.baud;
  }
  bool bytes_pile_up() const {
    return pass() * rate_.baud * facts_.fast_sender_percent >
           thousand * 100 * facts_.frame_bits * facts_.bytes_of_a_look * rate_.clock_hz;
  }
  std::uint64_t waiting_bytes() const;
  static Wide looks_for(std::uint64_t bytes, std::uint64_t at_a_time) {
    return (bytes + at_a_time - 1) / at_a_time;
  }

  Wide sign_of_life() const;
  Wide next_line() const;
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

std::uint64_t Situation::waiting_bytes() const {
  if (bytes_pile_up()) return facts_.unanswered_bytes;
  const Wide to_look = end(Task::serial_line);
  // So many wake the loop, or all come while it sleeps.
  const std::uint64_t asleep =
      std::min(facts_.wake_level + bytes_in(to_look), bytes_in(pass() + sleep() + to_look));
  return std::min(std::max(bytes_in(pass() + to_look), asleep), facts_.unanswered_bytes);
}

// A line is taken in so many looks; from then on the busy message is due `busy_lead` before 2 s,
// seen in the next pass after that, and given to the uart before the refill.
Wide Situation::sign_of_life() const {
  const Wide looks = looks_for(facts_.bytes_of_a_line, facts_.bytes_of_a_look);
  return looks * pass() + pass() + sleep() + begin(Task::refill) +
         time_of_bytes(facts_.busy_message_bytes);
}

// What has been handed over counts from the beginning of the pass in which it was. It must last
// until the first line of the next pass is in the queue, and from then on each line until the next
// one; all the rest of the task may come at once.
Wide Situation::next_line() const {
  const Wide before = begin(Task::refill), all = end(Task::refill);
  const Wide line = load_.line ? thousand * *load_.line : all - before;
  const Wide least = thousand * facts_.least_line_clocks;
  const Wide latest = std::max(std::min(before + line, all), all - least);
  return pass() + sleep() + latest;
}

// The rounds of the heaters begin a period apart, but for a pass and a sleep, and so does their
// last heater's turn; the second key comes at the end of that pass.
Wide Situation::heater_feed() const {
  return at_most(facts_.heat_period_ms + 1) + 2 * (pass() + sleep()) + pass();
}

// From a first key that comes late in its task to the next that comes at once. The task itself
// looks how long ago the last one was.
Wide Situation::early_heater_feed() const {
  return at_least(facts_.least_heat_ms - 1) - within_pass(load_.tasks, Task::heat);
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
  if (!load_.pass) return {.worst = {}, .is_bounded = false};
  const Wide tick = thousand * facts_.heater_tick_clocks;
  switch (requirement) {
    case Requirement::received_bytes: {
      const std::uint64_t bytes = waiting_bytes();
      return {
          .worst = bytes, .allowed = facts_.receive_depth, .holds = bytes <= facts_.receive_depth};
    }
    case Requirement::sign_of_life:
      return within(sign_of_life(), at_most(facts_.busy_lead_ms));
    case Requirement::stop_by_host:
      return within(
          looks_for(waiting_bytes(), facts_.bytes_of_a_look) * pass() + end(Task::serial_line),
          at_most(facts_.stop_within_ms));
    case Requirement::emergency_stop:
      return within(pass() + end(Task::faults), at_most(facts_.stop_within_ms));
    case Requirement::motion_watchdog:
      return within(pass() + sleep() + end(Task::motion) + thousand,
                    at_least(facts_.motion_watchdog_ms));
    case Requirement::horizon:
      return within(next_line(), at_most(facts_.horizon_ms));
    case Requirement::queue:
      return within(next_line(), thousand * facts_.least_line_clocks * facts_.lines_of_a_pass);
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
