// SPDX-License-Identifier: Apache-2.0
// The serial line's driver: when it interrupts, and how it finds the ends of lines.
#include "tests/drivers/uart_line.hpp"

namespace {

using tests::fast_line;
using tests::receive_depth;
using tests::transmit_depth;
using Line = tests::UartLine;

TEST(UartInterrupts, interrupts_at_its_thresholds) {
  Line line = fast_line();
  line.uart.interrupt_on({.receive_level = 2, .transmit_space = transmit_depth});
  line.chip.clock(2);
  EXPECT_FALSE(line.chip->receive_interrupt);
  EXPECT_TRUE(line.chip->transmit_interrupt);
  line.host.send("a");
  line.finish_sending();
  EXPECT_FALSE(line.chip->receive_interrupt);
  line.host.send("b");
  line.finish_sending();
  EXPECT_TRUE(line.chip->receive_interrupt);
  line.read(1);
  line.chip.clock(2);
  EXPECT_FALSE(line.chip->receive_interrupt);
  line.uart.write(std::string("xyz"));
  line.chip.clock(2);
  EXPECT_FALSE(line.chip->transmit_interrupt);
  line.finish_receiving();
  EXPECT_TRUE(line.chip->transmit_interrupt);
  line.uart.interrupt_on({});
  line.host.send("cdefg");
  line.finish_sending();
  EXPECT_FALSE(line.chip->receive_interrupt);
  EXPECT_FALSE(line.chip->transmit_interrupt);
}

TEST(UartInterrupts, interrupts_while_the_end_of_a_line_waits) {
  for (const char* end : {"\n", "\r", "\r\n"}) {
    Line line = fast_line();
    line.uart.interrupt_on({.line_end = true});
    line.host.send("M105");
    line.finish_sending();
    EXPECT_FALSE(line.chip->receive_interrupt);
    EXPECT_FALSE(line.uart.line_waits());
    line.host.send(std::string(end) + "G1");
    line.finish_sending();
    EXPECT_TRUE(line.chip->receive_interrupt);
    EXPECT_TRUE(line.uart.line_waits());
    EXPECT_EQ(line.read(4), "M105");
    line.chip.clock(2);
    EXPECT_TRUE(line.chip->receive_interrupt);
    const std::string_view ending(end);
    EXPECT_EQ(line.read(ending.size()), ending);
    line.chip.clock(2);
    EXPECT_FALSE(line.chip->receive_interrupt);
    EXPECT_FALSE(line.uart.line_waits());
    EXPECT_EQ(line.read(10), "G1");
  }
}

TEST(UartInterrupts, ends_lines_with_the_bytes_that_it_is_given) {
  Line line = fast_line();
  line.uart.interrupt_on({.line_end = true});
  line.uart.set_line_ends(';', ';');
  line.host.send("M105\n\r");
  line.finish_sending();
  EXPECT_FALSE(line.chip->receive_interrupt);
  line.host.send(";");
  line.finish_sending();
  EXPECT_TRUE(line.chip->receive_interrupt);
}

// The model sleeps between bytes: whatever the clock in which software reads a line, it is woken
// for the next one, and not again for what it has read.
TEST(UartInterrupts, loses_no_line_and_wakes_for_none_twice_whenever_it_is_read) {
  for (unsigned delay = 0; delay < 60; ++delay) {
    Line line = fast_line();
    line.uart.interrupt_on({.line_end = true});
    line.host.send("ab\n\ncd\n");
    std::string received;
    unsigned wakes = 0;
    for (const std::uint64_t end = line.chip.now() + 1000; line.chip.now() < end;) {
      line.chip.clock();
      if (!line.chip->receive_interrupt) continue;
      ++wakes;
      EXPECT_TRUE(line.uart.line_waits());
      line.chip.clock(delay);
      received += line.read(10);
      line.chip.clock(2);
    }
    EXPECT_EQ(received, "ab\n\ncd\n") << delay;
    EXPECT_FALSE(line.uart.line_waits());
    EXPECT_LE(wakes, 3u) << delay;
  }
}

TEST(UartInterrupts, is_not_woken_by_a_line_end_that_was_lost) {
  Line line = fast_line();
  line.uart.interrupt_on({.line_end = true});
  line.host.send(std::string(receive_depth, 'x') + "\n\n");
  line.finish_sending();
  EXPECT_EQ(line.uart.error_counts().overruns, 2);
  EXPECT_FALSE(line.chip->receive_interrupt);
  EXPECT_EQ(line.read(1), "x");
  line.host.send("\n");
  line.finish_sending();
  EXPECT_TRUE(line.chip->receive_interrupt);
  EXPECT_EQ(line.read(receive_depth).size(), receive_depth);
  line.chip.clock(2);
  EXPECT_FALSE(line.chip->receive_interrupt);
}

}  // namespace
