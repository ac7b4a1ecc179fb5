// SPDX-License-Identifier: Apache-2.0
// How often something happens at most, in several loops and functions together: a fact for
// tools/timing, which host tests check.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace units {

// What is counted.
enum class Event : std::uint32_t {
  byte_received,  // taken from the uart
  byte_taken,  // by the host link
  line_taken,  // likewise, complete
  byte_queued,  // of a reply
  byte_sent,  // given to the uart
  character_read,  // of a line's text by the parser, again after going back
  text_checked,  // a character of a text within that line, by the parser
  comment_skipped,  // likewise
  refused,  // a command, with its reason
  handler_called,  // of a command, or what reports in its place
  long_digit,  // nine digits of a number that needs more than 32 bits, written
  digit_written,  // of any number
  character_written,  // of a text that is put together
  looked_ahead,  // over the planner's lines
  line_looked_at,  // by that: a line that is not the only one
  lines_joined,  // a line to the one before
  line_begun,  // by the planner, for the step generator
  segment_made,  // likewise
  settled,  // a command: refused, or its line planned
  long_work,  // of which a pass does one: a command, heat, a report, a fault
  read_or_executed,  // of which a pass does one: bytes from the uart, a command
  received_or_executed,  // likewise: bytes to the host link, a command
  answered_or_executed,  // likewise: answers that are owed, a command
  planned_or_executed,  // likewise: a stop, a chord, homing, a command
  count
};

// On the chip these are no instructions, only entries in a section that is not loaded. On a host
// one too many ends the program.
namespace event_bounds {

enum Kind : std::uint32_t { event, begin, end };

#ifdef __riscv
template <Event what, std::uint32_t most, Kind kind>
[[gnu::always_inline]] inline void mark() {
  asm inline volatile(
      ".pushsection .debug_event_bounds,\"\",@progbits\n"
      ".word 1f, %0, %1, %2\n"
      ".popsection\n"
      "1:" ::"i"(what),
      "i"(most), "i"(kind));
}

template <Event what>
[[gnu::always_inline]] inline void mark_behind(std::size_t number) {
  asm inline volatile(
      ".pushsection .debug_event_bounds,\"\",@progbits\n"
      ".word 1f, %0, 0, 0\n"
      ".popsection\n"
      "1:" ::"i"(what),
      "r"(number));
}
#else
inline thread_local std::array<std::uint64_t, static_cast<std::size_t>(Event::count)> counts{};
#endif

}  // namespace event_bounds

// Where it happens. The place is known where the instruction before it leads only here: behind an
// access to a peripheral, a call, or the condition that leads here, but not first in a loop.
template <Event what>
[[gnu::always_inline]] inline void happens() {
#ifdef __riscv
  event_bounds::mark<what, 0, event_bounds::event>();
#else
  ++event_bounds::counts[static_cast<std::size_t>(what)];
#endif
}

// The same behind what loads or computes this number, which has no effect: where no other
// instruction is sure to be in front of it.
template <Event what>
[[gnu::always_inline]] inline void happens([[maybe_unused]] std::size_t behind) {
#ifdef __riscv
  event_bounds::mark_behind<what>(behind);
#else
  happens<what>();
#endif
}

// From here to the end of the object it happens at most so often, in all that is called too.
template <Event what, std::uint32_t most>
class EventBound {
 public:
  EventBound(const EventBound&) = delete;
  EventBound& operator=(const EventBound&) = delete;
#ifdef __riscv
  [[gnu::always_inline]] inline EventBound() {
    event_bounds::mark<what, most, event_bounds::begin>();
  }
  [[gnu::always_inline]] inline ~EventBound() {
    event_bounds::mark<what, most, event_bounds::end>();
  }
#else
  EventBound() = default;
  ~EventBound() {
    if (event_bounds::counts[static_cast<std::size_t>(what)] - before_ > most) std::abort();
  }

 private:
  std::uint64_t before_ = event_bounds::counts[static_cast<std::size_t>(what)];
#endif
};

}  // namespace units
