// SPDX-License-Identifier: Apache-2.0
// What ends the processor's sleep: the firmware's loop as on the chip, with bytes that come one
// by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "tests/application/dialogue.hpp"

namespace {

// Into the planner's ring and the link's queue.
constexpr int more_lines_than_fit = motion::Planner::capacity + host_link::LineQueue::capacity;

using application_test::clock_hz;

// Of time, while bytes come and otherwise.
constexpr std::uint32_t fine_step_clocks = 40, coarse_step_clocks = 400;
constexpr std::uint32_t byte_clocks_250k = clock_hz / 25'000;
constexpr std::uint32_t byte_clocks_3m = 27;
constexpr double millisecond = 1e-3;

// Passes begin when something wakes the processor, or the pass before had more to do.
class Loop {
 public:
  // Beyond the greeting and the first looks at everything.
  Loop() { live({}, 0.2); }

  // `bytes` come at this distance from now on, for so long; ends early with the first reply
  // where asked.
  void live(std::string_view bytes, double seconds, std::uint32_t byte_clocks = byte_clocks_250k,
            bool to_reply = false) {
    passes = 0;
    most_waiting = 0;
    const std::uint64_t begin = printer.chip.time;
    const auto end = begin + static_cast<std::uint64_t>(seconds * clock_hz);
    std::size_t come = 0;
    while (printer.chip.time < end) {
      printer.chip.advance(come < bytes.size() ? fine_step_clocks : coarse_step_clocks);
      while (come < bytes.size() && printer.chip.time >= begin + (come + 1) * byte_clocks) {
        printer.chip.to_firmware.push_back(bytes[come++]);
        last_byte_at = printer.chip.time;
      }
      most_waiting = std::max(most_waiting, printer.chip.to_firmware.size());
      if (!awake_ && !printer.chip.wakes()) continue;
      ++passes;
      awake_ = printer.pass_without_sleep();
      if (to_reply && !printer.chip.from_firmware.empty()) return;
    }
  }

  std::string take_replies() { return std::exchange(printer.chip.from_firmware, {}); }

  application_test::Printer printer;
  unsigned passes{};
  std::size_t most_waiting{};  // bytes in the FIFO
  std::uint64_t last_byte_at{};

 private:
  bool awake_ = true;
};

TEST(wake, a_line_is_answered_in_the_two_passes_that_its_end_begins) {
  for (const std::string line : {"G92 E0\n", "N0 G1 X0.1*127\n", "M105\r", "M105\r\n"}) {
    Loop loop;
    loop.live(line, 0.1, byte_clocks_250k, true);
    EXPECT_TRUE(loop.take_replies().starts_with("ok")) << line;
    // One takes it, one executes it, and what the timer's 8 ms may add to them.
    EXPECT_LE(loop.passes, 3u) << line;
    EXPECT_LT(loop.printer.chip.time - loop.last_byte_at, clock_hz / 2000) << line;
  }
}

// One takes it, the next one executes it.
TEST(wake, lines_on_each_others_heels_take_two_passes_each) {
  Loop loop;
  std::string lines;
  for (int i = 0; i < 8; ++i) lines += "G92 E0\n";
  loop.live(lines, 8 * millisecond);
  EXPECT_EQ(std::ranges::count(loop.take_replies(), '\n'), 8);
  EXPECT_LE(loop.passes, 18u);
}

TEST(wake, lines_that_came_together_are_done_without_sleep) {
  Loop loop;
  loop.live("G92 E0\nG92 E0\nG92 E0\nG92 E0\n", millisecond, 1);
  EXPECT_EQ(loop.take_replies(), "ok\nok\nok\nok\n");
}

TEST(wake, the_beginning_of_a_line_wakes_nothing) {
  Loop loop;
  loop.live("G1 X1", 0.08);
  EXPECT_LE(loop.passes, 13u);  // heat ends two passes
  loop.live("0\n", 0.1, byte_clocks_250k, true);
  EXPECT_EQ(loop.take_replies(), "ok\n");
}

TEST(wake, slow_typing_is_answered_at_the_end_of_the_line_and_once) {
  Loop loop;
  loop.live("M119", 0.5, clock_hz / 10);
  EXPECT_EQ(loop.take_replies(), "");
  loop.live("\r", 0.002);
  const std::string replies = loop.take_replies();
  EXPECT_TRUE(replies.starts_with("Reporting endstop status")) << replies;
  loop.live("\n", 0.1);
  EXPECT_EQ(loop.take_replies(), "");
}

TEST(wake, m112_acts_at_the_end_of_its_line) {
  Loop loop;
  loop.live("M112\n", 0.001);
  EXPECT_NE(loop.take_replies().find("Printer halted"), std::string::npos);
  // And then lines wake, are answered, and do not keep the processor awake.
  loop.live("M105\n", 1.0);
  EXPECT_NE(loop.take_replies().find("Printer halted"), std::string::npos);
  EXPECT_LE(loop.passes, 130u);
}

TEST(wake, a_flood_without_a_line_end_is_read_before_it_fills_the_fifo) {
  Loop loop;
  loop.live(std::string(20'000, 'x'), 0.07, byte_clocks_3m);
  EXPECT_LT(loop.most_waiting, 200u);
  EXPECT_LT(loop.printer.chip.to_firmware.size(), 64u);
}

TEST(wake, the_processor_sleeps_where_there_is_nothing_to_do) {
  Loop loop;
  loop.live({}, 1.0);
  EXPECT_LE(loop.passes, 146u);  // 20 of them behind heat
  // Held with a full planner: the move in hand waits for room that is not made.
  std::string lines = "G92 X0\n";
  for (int i = 1; i < more_lines_than_fit; ++i) lines += "G1 X" + std::to_string(i) + " F600\n";
  loop.live(lines, 0.02, byte_clocks_3m);
  EXPECT_LT(std::ranges::count(loop.take_replies(), '\n'), more_lines_than_fit);
  loop.live("//action:pause\n", 0.05);
  loop.live({}, 1.0);
  EXPECT_LE(loop.passes, 510u);
  // And with room that it may not use.
  loop.live("M410\n", 0.2);
  loop.live({}, 1.0);
  EXPECT_LE(loop.passes, 510u);
}

TEST(wake, a_move_that_waits_for_room_is_taken_in_the_wake_that_makes_it) {
  Loop loop;
  std::string lines = "G92 X0\nG91\nG1 F600\n";
  for (int i = 0; i < more_lines_than_fit; ++i) lines += "G1 X0.5\n";
  loop.live(lines, 0.02, byte_clocks_3m);
  loop.take_replies();
  // Motion makes room for a line each 50 ms; a pass that does takes the next move before it sleeps.
  unsigned answers = 0;
  for (int i = 0; i < 100; ++i) {
    loop.live({}, 8 * millisecond);
    const std::size_t count = loop.take_replies().size();
    if (count == 0) continue;
    ++answers;
    EXPECT_GE(loop.passes, 2u);
  }
  EXPECT_GT(answers, 2u);
}

// At a high clock 32 segments of short lines last shorter than a long sleep.
TEST(wake, a_full_step_queue_is_looked_at_more_often_than_at_rest) {
  Loop loop;
  loop.live("M201 X50000\nM204 P50000 T50000\nG91\nG1 F4800\n", 10 * millisecond);
  loop.take_replies();
  // Back and forth, so that each line has three segments; more lines than the planner holds.
  for (int i = 0; i < more_lines_than_fit / 4; ++i) {
    loop.live("G1 X.12\nG1 X-.12\nG1 X.12\nG1 X-.12\n", 2 * millisecond, 1);
  }
  loop.live({}, 16 * millisecond);
  EXPECT_GE(loop.passes, 6u);  // each 2 ms; two or three at rest
  EXPECT_EQ(loop.printer.chip.underruns, 0u);
}

}  // namespace
