// SPDX-License-Identifier: Apache-2.0
// Bytes cross the simulated line in both directions, at baud rates that do not divide the clock.
#include "sim/devices/serial_line.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <vector>

#include "sim/simulation/simulation.hpp"
#include "tests/sim/fake_chip.hpp"

namespace {

struct Bytes : devices::ByteListener {
  void byte_received(sim::Clock, std::uint8_t byte) override { text += static_cast<char>(byte); }
  std::string text;
};

// A chip of 4 MHz, and the line at its uart.
struct Connection {
  explicit Connection(std::uint32_t baud = 250'000, const devices::SerialFaults& faults = {},
                      unsigned clocks_per_bit = 16)
      : chip(clocks_per_bit), line(rate, baud, chip.inputs(), faults) {
    line.set_listener(bytes);
    simulation.attach(line, sim::OutputPins::transmit_pin());
    chip.firmware = [this](const std::string& came) {
      lines.push_back(came);
      return std::string();
    };
  }

  tests::FakeChip chip;
  sim::ClockRate rate{4'000'000};
  sim::Simulation simulation{chip, rate};
  devices::SerialLine line;
  Bytes bytes;  // from the chip
  std::vector<std::string> lines;  // to the chip
};

TEST(SerialLine, brings_every_byte_to_the_chip_and_back) {
  Connection connection;
  auto& [chip, rate, simulation, line, bytes, lines] = connection;
  std::string all;
  for (int byte = 1; byte < 256; ++byte) {
    if (byte != '\n') all += static_cast<char>(byte);
  }
  chip.firmware = [](const std::string& text) { return "<" + text + ">"; };
  line.send(0, all + "\n");
  simulation.run_until(200'000);
  EXPECT_EQ(bytes.text, "<" + all + ">");
  EXPECT_EQ(line.bytes_sent(), 255U);
  EXPECT_EQ(line.framing_errors(), 0U);
}

TEST(SerialLine, keeps_its_baud_rate_over_long_texts_where_it_does_not_divide_the_clock) {
  Connection connection(115'200, {}, 35);  // 34.72 clocks per bit
  auto& [chip, rate, simulation, line, bytes, lines] = connection;
  sim::Clock came_at = 0;
  chip.firmware = [&](const std::string& text) {
    EXPECT_EQ(text, std::string(500, 'U'));
    came_at = chip.now();
    return std::string();
  };
  line.send(0, std::string(500, 'U') + "\n");
  simulation.run_until(400'000);
  const double middle_of_last_stop_bit = (501 * 10 - 0.5) * 4e6 / 115'200;
  EXPECT_NEAR(static_cast<double>(came_at), middle_of_last_stop_bit, 5);
}

TEST(SerialLine, goes_on_at_another_speed_without_what_waited_for_the_one_before) {
  Connection connection(500'000);
  auto& [chip, rate, simulation, line, bytes, lines] = connection;
  line.send(0, std::string(1, '\xff') + "G1 X20\n");
  simulation.run_until(4);  // within the start bit
  line.set_baud(4, 250'000);
  line.send(4, "1234\n");
  simulation.run_until(2000);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_TRUE(lines.front().ends_with("1234")) << lines.front();
  EXPECT_LE(lines.front().size(), 5U);
}

TEST(SerialLine, hangs_up_with_a_break_and_goes_on_with_what_comes_after) {
  Connection connection;
  auto& [chip, rate, simulation, line, bytes, lines] = connection;
  line.send(0, "G1 X20");
  simulation.run_until(500);  // three bytes and a bit
  line.hang_up(500, 1'000);
  line.send(500, "M105\n");
  simulation.run_until(5'000);
  EXPECT_EQ(chip.breaks, 1U);
  EXPECT_EQ(lines, std::vector<std::string>{"M105"});
  line.hang_up(5'000, 1'000);
  line.set_baud(5'500, 250'000);
  simulation.run_until(8'000);
  EXPECT_EQ(chip.breaks, 2U);
  EXPECT_TRUE(chip.inputs().receive);
  line.send(8'000, "M114\n");
  simulation.run_until(10'000);
  EXPECT_EQ(lines.back(), "M114");
}

TEST(SerialLine, counts_a_frame_without_stop_bit_and_delivers_nothing) {
  Connection connection;
  auto& [chip, rate, simulation, line, bytes, lines] = connection;
  chip.plan(100, sim::OutputPins::transmit_bit, false);
  chip.plan(100 + 16 * 12, sim::OutputPins::transmit_bit, true);
  simulation.run_until(1000);
  EXPECT_EQ(line.framing_errors(), 1U);
  EXPECT_EQ(bytes.text, "");
}

TEST(SerialLine, corrupts_the_requested_share_of_bytes_and_repeats_it_by_the_seed) {
  const auto received = [](std::uint64_t seed) {
    Connection connection(250'000, {.corrupted_bytes = 0.1, .seed = seed});
    connection.line.send(0, std::string(1000, 'U') + "\n");
    connection.simulation.run_until(200'000);
    EXPECT_GT(connection.line.bytes_corrupted(), 60U);
    EXPECT_LT(connection.line.bytes_corrupted(), 140U);
    return connection.lines;
  };
  EXPECT_EQ(received(7), received(7));
  EXPECT_NE(received(7), received(8));
}

TEST(SerialLine, corrupts_bytes_of_the_requested_direction) {
  for (const bool replies : {false, true}) {
    devices::SerialFaults faults;
    (replies ? faults.corrupted_replies : faults.corrupted_bytes) = 0.1;
    Connection connection(250'000, faults);
    auto& [chip, rate, simulation, line, bytes, lines] = connection;
    chip.say(std::string(1000, 'U'));
    line.send(0, std::string(1000, 'U'));
    simulation.run_until(300'000);
    ASSERT_EQ(bytes.text.size(), 1000U);
    const auto corrupted = static_cast<std::uint64_t>(1000 - std::ranges::count(bytes.text, 'U'));
    EXPECT_EQ(corrupted, line.replies_corrupted());
    EXPECT_EQ(line.replies_corrupted() > 50, replies);
    EXPECT_EQ(line.bytes_corrupted() > 50, !replies);
  }
}

TEST(SerialLine, carries_nothing_in_either_direction_while_the_cable_is_pulled) {
  Connection connection;
  auto& [chip, rate, simulation, line, bytes, lines] = connection;
  const auto say_in_both_directions = [&](const std::string& text) {
    line.send(chip.now(), text + "\n");
    chip.say(text + "\n");
    simulation.run_until(chip.now() + 5000);
  };
  say_in_both_directions("one");
  line.connect(false);
  say_in_both_directions("two");
  EXPECT_TRUE(chip.inputs().receive);
  line.connect(true);
  say_in_both_directions("three");
  EXPECT_EQ(bytes.text, "one\nthree\n");
  EXPECT_THAT(lines, testing::ElementsAre("one", "three"));
  EXPECT_EQ(line.bytes_lost(), 4U);
}

}  // namespace
