// SPDX-License-Identifier: Apache-2.0
// The reply texts, compared with what hosts' parsers and regular expressions expect.
#include "host_link/replies.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <random>
#include <regex>
#include <string>

namespace host_link {
namespace {

using units::Millicelsius;
using units::Nanometers;
using units::Steps;

std::string text(const TextLine& line) {
  EXPECT_TRUE(line.complete());
  return std::string(line.view());
}

std::string decimal(std::int64_t value, unsigned digits, unsigned places) {
  TextLine line;
  return text(line.decimal(value, digits, places));
}

TEST(text_line, writes_decimals_rounded_half_away_from_zero) {
  EXPECT_EQ(decimal(205'104, 3, 2), "205.10");
  EXPECT_EQ(decimal(205'105, 3, 2), "205.11");
  EXPECT_EQ(decimal(-205'105, 3, 2), "-205.11");
  EXPECT_EQ(decimal(999'995, 3, 2), "1000.00");
  EXPECT_EQ(decimal(-4, 3, 2), "0.00");
  EXPECT_EQ(decimal(5, 6, 2), "0.00");
  EXPECT_EQ(decimal(12'345, 3, 0), "12");
  EXPECT_EQ(decimal(42, 2, 2), "0.42");
}

TEST(text_line, writes_integers_of_any_size) {
  const auto integer = [](std::int64_t value) {
    TextLine line;
    return text(line.integer(value));
  };
  EXPECT_EQ(integer(0), "0");
  EXPECT_EQ(integer(-17), "-17");
  EXPECT_EQ(integer(4'294'967'296), "4294967296");
  EXPECT_EQ(integer(std::numeric_limits<std::int64_t>::min()), "-9223372036854775808");
}

TEST(text_line, writes_numbers_of_any_size_with_any_number_of_places) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20'000; ++i) {
    const auto value = static_cast<std::int64_t>(random() >> (1 + random() % 63));
    const auto places = static_cast<unsigned>(random() % 7);
    std::string digits = std::to_string(value);
    if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
    if (places != 0) digits.insert(digits.size() - places, ".");
    ASSERT_EQ(decimal(value, places, places), digits);
    ASSERT_EQ(decimal(-value, places, places), value == 0 ? digits : "-" + digits);
  }
}

TEST(text_line, reports_what_does_not_fit) {
  TextLine line;
  line.text(std::string(TextLine::capacity, 'x'));
  EXPECT_TRUE(line.complete());
  line.character('y');
  EXPECT_FALSE(line.complete());
  EXPECT_EQ(line.view(), std::string(TextLine::capacity, 'x'));
  line.clear();
  EXPECT_TRUE(line.complete());
  EXPECT_TRUE(line.view().empty());
}

TEST(replies, report_temperatures_as_marlin) {
  const HeaterState hotend{Millicelsius(205'100), Millicelsius(205'000), 64};
  const HeaterState bed{Millicelsius(59'996), Millicelsius(60'000), 0};
  const std::string report = text(temperature_report(hotend, bed));
  EXPECT_EQ(report, " T:205.10 /205.00 B:60.00 /60.00 @:64 B@:0");
  host_link::TextLine waiting = temperature_report(hotend, bed);
  add_waiting_time(waiting, 3);
  EXPECT_EQ(text(waiting), report + " W:3");
  waiting = temperature_report(hotend, bed);
  add_waiting_time(waiting, std::nullopt);
  EXPECT_EQ(text(waiting), report + " W:?");
  // Printrun's expression finds the hotend and its target.
  const std::regex printrun(R"(([TB]\d*):([-+]?\d*\.?\d*)(?: ?\/)?([-+]?\d*\.?\d*))");
  std::smatch match;
  ASSERT_TRUE(std::regex_search(report, match, printrun));
  EXPECT_EQ(match[2], "205.10");
  EXPECT_EQ(match[3], "205.00");
}

TEST(replies, report_the_position_in_the_order_that_octoprint_needs) {
  const units::PerAxis<units::Position> position{Nanometers(10'004'999), Nanometers(-500'000),
                                                 Nanometers(0), Nanometers(1'234'567'890)};
  const units::PerAxis<Steps> count{Steps(800), Steps(-40), Steps(0), Steps(7)};
  EXPECT_EQ(text(position_report(position, count)),
            "X:10.00 Y:-0.50 Z:0.00 E:1234.57 Count X:800 Y:-40 Z:0");
}

TEST(replies, report_coordinates_as_far_away_as_g92_sets_them) {
  units::PerAxis<units::Position> position;
  position.fill(Nanometers(-1'000'000'000'000'000));
  EXPECT_EQ(text(position_report(position, {Steps(1), Steps(2), Steps(3), Steps(0)})),
            "X:-1000000000.00 Y:-1000000000.00 Z:-1000000000.00 E:-1000000000.00 "
            "Count X:1 Y:2 Z:3");
}

TEST(replies, describe_the_firmware_line_by_line) {
  constexpr std::array capabilities{Capability{"EMERGENCY_PARSER", true},
                                    Capability{"AUTOREPORT_TEMP", false}};
  const FirmwareDescription firmware{"StepFabric 0.1.0", "", "Prusa Mendel", 1, capabilities};
  const std::string first = text(firmware_line(firmware, 0).value());
  EXPECT_EQ(first,
            "FIRMWARE_NAME:StepFabric 0.1.0 PROTOCOL_VERSION:1.0; MACHINE_TYPE:Prusa Mendel "
            "EXTRUDER_COUNT:1");
  EXPECT_EQ(text(firmware_line(firmware, 1).value()), "Cap:EMERGENCY_PARSER:1");
  EXPECT_EQ(text(firmware_line(firmware, 2).value()), "Cap:AUTOREPORT_TEMP:0");
  EXPECT_FALSE(firmware_line(firmware, 3).has_value());
}

TEST(replies, report_end_stops_line_by_line) {
  constexpr std::array end_stops{EndStopState{"x_min", true}, EndStopState{"y_min", false}};
  EXPECT_EQ(text(end_stop_line(end_stops, 0).value()), "Reporting endstop status");
  EXPECT_EQ(text(end_stop_line(end_stops, 1).value()), "x_min: TRIGGERED");
  EXPECT_EQ(text(end_stop_line(end_stops, 2).value()), "y_min: open");
  EXPECT_FALSE(end_stop_line(end_stops, 3).has_value());
}

// OctoPrint stops the print on an "Error:" that it does not know.
TEST(replies, tell_refusals_as_echo) {
  EXPECT_EQ(text(unknown_command("G999 X1")), "echo:Unknown command: \"G999 X1\"");
  EXPECT_EQ(text(not_executed("malformed number", 7, "G1 X1.2.3")),
            "echo:malformed number at column 8, not executed: \"G1 X1.2.3\"");
  EXPECT_EQ(text(not_executed("cold extrusion prevented", "G1 E5")),
            "echo:cold extrusion prevented, not executed: \"G1 E5\"");
}

}  // namespace
}  // namespace host_link
