// SPDX-License-Identifier: Apache-2.0
// The serial line's driver: baud rates, bytes in and out, lost and broken ones.
#include "tests/drivers/uart_line.hpp"

namespace {

using tests::all_bytes;
using tests::fast_line;
using tests::receive_depth;
using tests::transmit_depth;
using Line = tests::UartLine;

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
  EXPECT_EQ(line.read(receive_depth), text.substr(0, receive_depth));
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

TEST(Uart, reads_no_further_than_the_end_of_a_line) {
  Line line = fast_line();
  line.uart.set_line_ends('\n', '\r');
  const auto read_line = [&] {
    std::string text(100, '\0');
    text.resize(line.uart.read_line(text).count);
    return text;
  };
  line.host.send("M105\nG1 X1\r\nG28\r\r\n\n\tM1");
  line.finish_sending();
  for (const char* const expected : {"M105\n", "G1 X1\r", "\nG28\r", "\r", "\n\n", "\tM1", ""}) {
    EXPECT_EQ(read_line(), expected);
  }
  // The end in front was that of a line with text.
  line.host.send("\n\n");
  line.finish_sending();
  EXPECT_EQ(read_line(), "\n");
  EXPECT_EQ(read_line(), "\n");
}

}  // namespace
