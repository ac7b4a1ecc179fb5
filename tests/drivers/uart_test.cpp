// SPDX-License-Identifier: Apache-2.0
// The serial line's driver against the serial line, with a host at the other end of the wire.
#include "drivers/uart.hpp"

#include <gtest/gtest.h>

#include <Vuart.h>
#include <array>
#include <span>
#include <string>

#include "drivers/registers/uart_registers.hpp"
#include "tests/drivers/serial_host.hpp"
#include "tests/drivers/verilated_bus.hpp"

namespace {

constexpr std::size_t receive_depth = 2048;
constexpr std::size_t transmit_depth = 512;

// A line of `baud` on a chip that is clocked with `clock_hz`; the host's speed is off by
// `deviation`.
class Line {
 public:
  Line(std::uint32_t baud, std::uint32_t clock_hz, double deviation = 0)
      : host((1 + deviation) * clock_hz / baud) {
    chip->receive = 1;
    chip.after_clock = [this] { chip->receive = host.clock(chip->transmit != 0); };
    EXPECT_TRUE(uart.configure(baud, units::Hertz(clock_hz)));
  }

  // Until the host has sent everything, and a frame longer.
  void finish_sending() {
    while (host.sending()) chip.clock();
    chip.clock(50);
  }
  void finish_receiving() {
    while (!uart.transmit_idle()) chip.clock();
    chip.clock(50);
  }

  std::string read(std::size_t most) {
    std::string text(most, '\0');
    std::size_t count = 0;
    for (std::size_t more = 1; more != 0; count += more) {
      more = uart.read(std::span(text).subspan(count)).count;
    }
    text.resize(count);
    return text;
  }

  tests::VerilatedPeripheral<Vuart> chip{registers::uart::base};
  tests::SerialHost host;
  drivers::Uart uart;
};

Line fast_line() { return {1'000'000, 4'000'000}; }

std::string all_bytes(std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += static_cast<char>(i * 7 + i / 256);
  return text;
}

TEST(Uart, rounds_the_increment_to_nearest) {
  using drivers::Uart;
  using units::Hertz;
  static_assert(Uart::increment(1'000'000, Hertz(4'000'000)) == 1u << 30);
  static_assert(Uart::increment(115'200, Hertz(50'000'000)) == 9'895'605);
  static_assert(Uart::increment(3'000'000, Hertz(50'000'000)) == 257'698'038);
  EXPECT_EQ(Uart::increment(1'500'000, Hertz(100'000'000)), 64'424'509u);
}

TEST(Uart, refuses_what_the_clock_is_too_slow_for) {
  using drivers::Uart;
  using units::Hertz;
  static_assert(!Uart::increment(1'000'001, Hertz(4'000'000)));
  static_assert(!Uart::increment(3'000'000, Hertz(0)));
  static_assert(!Uart::increment(0, Hertz(50'000'000)));

  Line line(1'000'000, 4'000'000);
  EXPECT_FALSE(line.uart.configure(2'000'000, Hertz(4'000'000)));
  line.host.send("as before");
  line.finish_sending();
  EXPECT_EQ(line.read(100), "as before");
}

TEST(Uart, talks_at_every_usual_speed_to_a_host_that_is_off_by_3_percent) {
  const struct {
    std::uint32_t baud, clock_hz;
  } speeds[] = {
      {115'200, 4'000'000},   {250'000, 4'000'000},    {1'000'000, 4'000'000},
      {250'000, 8'000'000},   {115'200, 50'000'000},   {1'000'000, 50'000'000},
      {2'000'000, 8'000'000}, {3'000'000, 50'000'000}, {3'000'000, 100'000'000},
  };
  const std::string text = all_bytes(100);
  for (const auto& speed : speeds) {
    for (const double deviation : {-0.03, 0.0, 0.03}) {
      SCOPED_TRACE(testing::Message()
                   << speed.baud << " baud at " << speed.clock_hz << " Hz, host " << deviation);
      Line line(speed.baud, speed.clock_hz, deviation);
      line.host.send(text);
      EXPECT_EQ(line.uart.write(text), text.size());
      line.finish_sending();
      line.finish_receiving();
      EXPECT_EQ(line.read(200), text);
      EXPECT_EQ(line.host.received(), text);
      EXPECT_EQ(line.host.framing_errors(), 0u);
      EXPECT_FALSE(line.uart.errors().any());
    }
  }
}

TEST(Uart, reads_no_more_than_fits_and_no_more_than_has_come) {
  Line line = fast_line();
  EXPECT_EQ(line.read(10), "");
  line.host.send("N1 G28*18\n");
  line.finish_sending();
  EXPECT_EQ(line.uart.receive_level(), 10u);
  EXPECT_EQ(line.read(4), "N1 G");
  EXPECT_EQ(line.uart.receive_level(), 6u);
  EXPECT_EQ(line.read(0), "");
  EXPECT_EQ(line.read(100), "28*18\n");
  EXPECT_EQ(line.uart.receive_level(), 0u);
}

TEST(Uart, writes_no_more_than_there_is_space_for) {
  Line line = fast_line();
  EXPECT_EQ(line.uart.transmit_space(), transmit_depth);
  const std::string text = all_bytes(2 * transmit_depth);
  const std::size_t accepted = line.uart.write(text);
  EXPECT_EQ(accepted, transmit_depth);
  EXPECT_FALSE(line.uart.transmit_idle());
  line.finish_receiving();
  EXPECT_EQ(line.host.received(), text.substr(0, accepted));
  EXPECT_EQ(line.uart.transmit_space(), transmit_depth);
}

TEST(Uart, takes_a_stream_of_any_length_when_it_is_served) {
  Line line = fast_line();
  const std::string text = all_bytes(5000);
  line.host.send(text);
  std::string received;
  std::string_view rest = text;
  while (line.host.sending() || !rest.empty()) {
    rest.remove_prefix(line.uart.write(rest));
    line.chip.clock(1000);
    received += line.read(300);
  }
  line.finish_receiving();
  received += line.read(300);
  EXPECT_EQ(received, text);
  EXPECT_EQ(line.host.received(), text);
}

TEST(Uart, reports_and_counts_lost_bytes) {
  Line line = fast_line();
  const std::string text = all_bytes(receive_depth + 5);
  line.host.send(text);
  line.finish_sending();
  EXPECT_TRUE(line.uart.errors().overrun);
  EXPECT_FALSE(line.uart.errors().framing_error);
  EXPECT_EQ(line.uart.error_counts().overruns, 5);
  EXPECT_EQ(line.read(text.size()), text.substr(0, receive_depth));
  line.uart.clear_errors();
  EXPECT_FALSE(line.uart.errors().any());
  EXPECT_EQ(line.uart.error_counts().overruns, 5);
}

TEST(Uart, reports_and_counts_framing_errors_and_breaks) {
  Line line = fast_line();
  line.host.send("a");
  line.host.send_without_stop_bit('b');
  line.host.send("c");
  line.finish_sending();
  EXPECT_TRUE(line.uart.errors().framing_error);
  EXPECT_FALSE(line.uart.errors().break_condition);
  line.host.send_break(15);
  line.host.send_break(100);
  line.host.send("d");
  line.finish_sending();
  EXPECT_TRUE(line.uart.errors().break_condition);
  EXPECT_EQ(line.read(10), "acd");
  EXPECT_EQ(line.uart.error_counts().framing_errors, 1);
  EXPECT_EQ(line.uart.error_counts().breaks, 2);
  EXPECT_EQ(line.uart.error_counts().overruns, 0);
  line.uart.clear_errors();
  EXPECT_FALSE(line.uart.errors().any());
}

TEST(Uart, stops_reading_at_the_byte_behind_a_gap) {
  Line line = fast_line();
  line.host.send("ab");
  line.host.send_without_stop_bit('x');
  line.host.send("cd");
  line.finish_sending();
  std::string text(10, '\0');
  const drivers::ReceivedBytes first = line.uart.read(text);
  EXPECT_EQ(text.substr(0, first.count), "abc");
  EXPECT_TRUE(first.gap_before_last);
  const drivers::ReceivedBytes second = line.uart.read(text);
  EXPECT_EQ(text.substr(0, second.count), "d");
  EXPECT_FALSE(second.gap_before_last);
}

TEST(Uart, marks_the_byte_behind_an_overrun) {
  Line line = fast_line();
  line.host.send(all_bytes(receive_depth + 5));
  line.finish_sending();
  std::string text(2000, '\0');
  EXPECT_FALSE(line.uart.read(std::span(text).first(100)).gap_before_last);
  line.host.send("z");
  line.finish_sending();
  const drivers::ReceivedBytes rest = line.uart.read(text);
  EXPECT_EQ(rest.count, receive_depth - 100 + 1);
  EXPECT_TRUE(rest.gap_before_last);
  EXPECT_EQ(text[rest.count - 1], 'z');
}

TEST(Uart, interrupts_at_its_thresholds) {
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

TEST(Uart, interrupts_while_the_end_of_a_line_waits) {
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

TEST(Uart, ends_lines_with_the_bytes_that_it_is_given) {
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
TEST(Uart, loses_no_line_and_wakes_for_none_twice_whenever_it_is_read) {
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

TEST(Uart, is_not_woken_by_a_line_end_that_was_lost) {
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
