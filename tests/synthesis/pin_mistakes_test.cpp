// SPDX-License-Identifier: Apache-2.0
// Each kind of mistake in the tables of signals and pins, or in their generator, is found.
#include <gmock/gmock.h>

#include <array>
#include <fstream>
#include <iterator>
#include <sstream>

#include "directories.hpp"
#include "tests/synthesis/pin_needs.hpp"
#include "tests/synthesis/pin_places.hpp"
#include "tools/files/file_text.hpp"

namespace synthesis {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

// A copy of what the constraints are made of, to put mistakes in.
class Mistake : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    for (const char* part : {"constraints", "boards/ulx3s", "boards/de2_115", "boards/de2_70",
                             "boards/de2_70_reprap_2012", "tools/hardware"}) {
      fs::create_directories(folder_ / part);
      fs::copy(fs::path(PROJECT_DIRECTORY) / part, folder_ / part, fs::copy_options::recursive);
    }
    fs::copy(fs::path(PROJECT_DIRECTORY) / "boards/header40.csv", folder_ / "boards");
    ASSERT_THAT(shortcomings(), IsEmpty());
  }
  void TearDown() override { fs::remove_all(folder_); }

  void replace(const char* file, const std::string& old_text, const std::string& new_text) const {
    std::string text = files::text_of(folder_ / file);
    const std::size_t place = text.find(old_text);
    ASSERT_NE(place, std::string::npos) << old_text;
    ASSERT_EQ(text.find(old_text, place + 1), std::string::npos) << old_text;
    text.replace(place, old_text.size(), new_text);
    std::ofstream(folder_ / file) << text;
  }
  std::vector<std::string> shortcomings(const char* board = "ulx3s") const {
    return shortcomings_of(folder_, board);
  }

  // Exchanges the signals of two ports in a table of connections.
  void swap_ports(const std::string& board, const std::string& one,
                  const std::string& other) const {
    const fs::path file = folder_ / "boards" / board / "connections.csv";
    std::ofstream swapped(folder_ / "swapped");
    std::istringstream lines(files::text_of(file));
    for (std::string line; std::getline(lines, line);) {
      const std::size_t comma = line.find(',');
      const std::string port = line.substr(0, comma);
      swapped << (port == one ? other : port == other ? one : port) << line.substr(comma) << '\n';
    }
    swapped.close();
    fs::rename(folder_ / "swapped", file);
  }

  static constexpr const char* signals = "constraints/signals.csv";
  static constexpr const char* connections = "boards/ulx3s/connections.csv";
  fs::path folder_ = fs::path(testing::TempDir()) / "stepfabric pins test";
};

TEST_F(Mistake, a_pull_on_a_sensor_is_found) {
  replace(signals, "sensor_resistor,out,none", "sensor_resistor,out,up");
  replace(signals, "sensor_sense,in,none", "sensor_sense,in,down");
  const auto found = shortcomings();
  EXPECT_EQ(found.size(), 8u);
  EXPECT_THAT(found, Contains("sensor_resistor[5] has pull UP, needs NONE"));
  EXPECT_THAT(found, Contains("sensor_sense[0] has pull DOWN, needs NONE"));
}

TEST_F(Mistake, a_missing_pull_is_found) {
  for (const char* row : {"emergency_stop,in,up", "end_stop,in,up", "motion_start,in,down",
                          "heater_gate,out,down", "motor_enable_n,out,up"}) {
    const std::string good = row;
    replace(signals, good, good.substr(0, good.rfind(',')) + ",none");
    EXPECT_THAT(shortcomings(), Contains(HasSubstr("has pull NONE, needs"))) << good;
    TearDown();
    SetUp();
  }
}

TEST_F(Mistake, a_generator_that_drops_the_pull_is_found) {
  replace("tools/hardware/write_constraints.sh", " \" PULLMODE=\" toupper(pull[signal])", "");
  EXPECT_THAT(shortcomings(), Contains("sensor_sense[1] has pull , needs NONE"));
}

TEST_F(Mistake, a_wrong_drive_or_slew_is_found) {
  replace(signals, "step,out,none,8,slow", "step,out,none,16,fast");
  replace(signals, "sensor_resistor,out,none,8", "sensor_resistor,out,none,4");
  EXPECT_THAT(shortcomings(), Contains("step[0] drives 16 mA, needs 8 to 8"));
  EXPECT_THAT(shortcomings(), Contains("step[4] has edges that ring"));
  EXPECT_THAT(shortcomings(), Contains("sensor_resistor[0] drives 4 mA, needs 8 to 16"));
  replace(signals, "sensor_sense,in,none,,", "sensor_sense,in,none,8,slow");
  EXPECT_THAT(shortcomings(), Contains(HasSubstr("drive and slew are for outputs")));
}

TEST_F(Mistake, a_sensor_in_a_bank_of_another_voltage_is_found) {
  replace("boards/ulx3s/banks.csv", "8,3.3", "8,2.5");
  ASSERT_THAT(shortcomings(), IsEmpty());
  replace(connections, "sensor_sense[1],gn[22]", "sensor_sense[1],btn[2]");
  EXPECT_THAT(shortcomings(), Contains(HasSubstr("sensor_sense[1] needs 3.3 V, bank 8 has 2.5")));
}

TEST_F(Mistake, a_pin_of_two_ports_is_found) {
  replace(connections, "sensor_sense[1],gn[22]", "sensor_sense[1],gn[21]");
  EXPECT_THAT(shortcomings(),
              Contains(HasSubstr("sensor_sense[1] and sensor_sense[0] share a pin")));
}

TEST_F(Mistake, a_port_without_a_pin_is_found) {
  replace(connections, "fan_gate,gn[9]\n", "");
  EXPECT_THAT(shortcomings(), Contains("fan_gate has no pin"));
}

TEST_F(Mistake, a_port_that_is_connected_twice_is_found) {
  replace(connections, "fan_gate,gn[9]\n", "fan_gate,gn[9]\nfan_gate,gn[23]\n");
  EXPECT_THAT(shortcomings(), Contains(HasSubstr("fan_gate is connected twice")));
}

TEST_F(Mistake, a_clock_without_a_constraint_or_with_another_frequency_is_found) {
  const char* timing = "constraints/ulx3s.lpf";
  const std::string good = "FREQUENCY PORT \"clk_25mhz\" 25 MHZ;";
  replace(timing, good, "FREQUENCY PORT \"clk_25mhz\" 20 MHZ;");
  EXPECT_THAT(shortcomings(), Contains("clk_25mhz is constrained to another frequency"));
  replace(timing, "\"clk_25mhz\" 20 MHZ", "\"clk\" 25 MHZ");
  EXPECT_THAT(shortcomings(), Contains("clk_25mhz has 0 timing constraints"));
  replace(timing, "FREQUENCY PORT \"clk\" 25 MHZ;", "# " + good + "\n");
  EXPECT_THAT(shortcomings(), Contains("clk_25mhz has 0 timing constraints"));
}

TEST_F(Mistake, a_signal_of_unknown_needs_is_found) {
  replace(signals, "fan_gate,", "fan,");
  EXPECT_THAT(shortcomings(), Contains(HasSubstr("does not say what fan_gate needs")));
}

TEST_F(Mistake, a_gate_on_a_pin_of_the_radio_module_is_found) {
  replace(connections, "heater_gate[1],gn[10]", "heater_gate[1],gp[11]");
  EXPECT_THAT(shortcomings(), Contains("heater_gate[1] can be driven by the radio module too"));
}

TEST_F(Mistake, a_resistor_that_is_missing_or_too_weak_outside_is_found) {
  replace(signals, "heater_gate,out,down,8,slow,pad,3.3,down,1500",
          "heater_gate,out,down,8,slow,pad,3.3,down,10000");
  replace(signals, "motor_enable_n,out,up,4,slow,pad,3.3,up,4700",
          "motor_enable_n,out,up,4,slow,pad,3.3,,");
  EXPECT_THAT(shortcomings(), Contains("heater_gate[1] has a wrong resistor outside"));
  EXPECT_THAT(shortcomings(), Contains("motor_enable_n[0] needs another resistor outside"));
}

TEST_F(Mistake, an_output_without_its_register_in_the_pad_is_found) {
  replace(signals, "step,out,none,8,slow,pad", "step,out,none,8,slow,");
  EXPECT_THAT(shortcomings(), Contains("step[3] has its register elsewhere"));
  replace(signals, "sensor_sense,in,none,,,", "sensor_sense,in,none,,,pad");
  EXPECT_THAT(shortcomings(), Contains(HasSubstr("a register is in the pad of an output")));
}

// What holds a gate against an ECP5 does not against a Cyclone, which pulls up with 7 kOhm.
TEST_F(Mistake, a_resistor_that_is_too_weak_for_a_cyclone_is_found) {
  replace(signals, "heater_gate,out,down,8,slow,pad,3.3,down,1500",
          "heater_gate,out,down,8,slow,pad,3.3,down,4700");
  EXPECT_THAT(shortcomings(), IsEmpty());
  EXPECT_THAT(shortcomings("de2_115"), Contains("heater_gate[0] has a wrong resistor outside"));
}

TEST_F(Mistake, a_bank_that_contradicts_a_pins_standard_is_found) {
  ASSERT_THAT(shortcomings("de2_115"), IsEmpty());
  replace("boards/de2_115/banks.csv", "7,2.5", "7,3.3");
  EXPECT_THAT(shortcomings("de2_115"), Contains(HasSubstr("LEDG[0] is 2.5 V in the table")));
  replace("boards/de2_115/banks.csv", "7,3.3", "7,2.5");
  replace("boards/de2_115/banks.csv", "4,3.3", "4,2.5");
  EXPECT_THAT(shortcomings("de2_115"), Contains(HasSubstr("needs 3.3 V, bank 4 has 2.5")));
}

TEST_F(Mistake, an_output_or_a_pull_on_a_clock_input_is_found) {
  ASSERT_THAT(shortcomings("de2_70"), IsEmpty());
  const char* table = "boards/de2_70/connections.csv";
  replace(table, "sensor_sense[0],GPIO_CLKIN_N0", "sensor_sense[0],GPIO_0[28]");
  replace(table, "fan_gate,GPIO_0[28]", "fan_gate,GPIO_CLKIN_N0");
  EXPECT_THAT(shortcomings("de2_70"), Contains(HasSubstr("GPIO_CLKIN_N0 is a clock input")));
  replace(table, "fan_gate,GPIO_CLKIN_N0", "fan_gate,GPIO_0[6]");
  replace(table, "end_stop[0],GPIO_0[6]", "end_stop[0],GPIO_CLKIN_N0");
  EXPECT_THAT(shortcomings("de2_70"), Contains(HasSubstr("GPIO_CLKIN_N0 is a clock input")));
}

TEST_F(Mistake, an_input_that_a_cyclone_cannot_hold_low_is_found) {
  replace("boards/de2_115/connections.csv", "tck,EX_IO[0]", "motion_start,EX_IO[0]");
  EXPECT_THAT(shortcomings("de2_115"), Contains(HasSubstr("no pull-down for motion_start")));
}

TEST_F(Mistake, in_the_pins_of_2012_is_found) {
  const char* board = "de2_70_reprap_2012";
  const char* table = "boards/de2_70_reprap_2012/connections.csv";
  ASSERT_THAT(shortcomings(board), IsEmpty());
  replace(table, "motor_reset_n[0],GPIO_0[4]", "motor_reset_n[0],GPIO_0[6]");
  EXPECT_THAT(shortcomings(board), Contains(HasSubstr("share a pin")));
  replace(table, "motor_reset_n[0],GPIO_0[6]", "motor_reset_n[0],GPIO_0[4]");
  replace(signals, "motor_reset_n,out,down,4,slow,pad,3.3,down,1500",
          "motor_reset_n,out,down,4,slow,pad,3.3,up,4700");
  EXPECT_THAT(shortcomings(board), Contains("motor_reset_n[4] needs another resistor outside"));
}

TEST_F(Mistake, a_pin_that_the_table_does_not_have_is_found) {
  replace("boards/de2_115/connections.csv", "tck,EX_IO[0]", "tck,EX_IO[7]");
  EXPECT_THAT(shortcomings("de2_115"), Contains(HasSubstr("no pin for EX_IO[7]")));
}

// Pairs that are alike for all other checks.
TEST_F(Mistake, two_ports_in_each_others_place_are_found) {
  for (const auto& [board, one, other] : std::vector<std::array<const char*, 3>>{
           {"de2_115", "uart_rxd", "uart_txd"},
           {"de2_115", "led[0]", "led[7]"},
           {"de2_115", "tck", "tms"},
           {"de2_115", "clock_50mhz", "clock_25mhz"},
           {"de2_70", "uart_rxd", "uart_txd"},
           {"de2_70", "tdi", "tms"},
           {"de2_70_reprap_2012", "fan_gate", "heater_supply"},
           {"de2_70_reprap_2012", "emergency_stop", "sensor_sense[1]"},
           {"de2_70_reprap_2012", "sensor_resistor[4]", "sensor_resistor[5]"},
           {"ulx3s", "ftdi_txd", "ftdi_rxd"},
           {"ulx3s", "led[0]", "led[7]"}}) {
    ASSERT_THAT(misplaced_in(folder_, board), IsEmpty());
    swap_ports(board, one, other);
    const auto found = misplaced_in(folder_, board);
    EXPECT_THAT(found, Contains(HasSubstr(std::string(one) + " is at "))) << board;
    EXPECT_THAT(found, Contains(HasSubstr(std::string(other) + " is at "))) << board;
    swap_ports(board, one, other);
  }
}

TEST_F(Mistake, a_signal_on_another_ball_than_on_the_board_is_found) {
  const char* pins = "boards/de2_115/pins.csv";
  replace(pins, "LEDG[0],E21", "LEDG[0],E22");
  replace(pins, "LEDG[1],E22", "LEDG[1],E21");
  EXPECT_THAT(misplaced_in(folder_, "de2_115"), Contains("led[0] is at E22, on the board at E21"));
  replace("boards/ulx3s/connections.csv", "tck,gn[5]", "tck,btn[1]");
  EXPECT_THAT(misplaced_in(folder_, "ulx3s"),
              Contains("tck lies where nothing says what is there"));
}

TEST_F(Mistake, a_ball_that_the_device_does_not_have_is_found) {
  const char* pins = "boards/de2_115/pins.csv";
  std::string now = "EX_IO[3],H14";
  for (const std::string ball : {"ZZ9", "E29", "I5", "AJ1", "A0", "AO3", "E21x"}) {
    const std::string bad = "EX_IO[3]," + ball;
    replace(pins, now + ",", bad + ",");
    now = bad;
    EXPECT_THAT(misplaced_in(folder_, "de2_115"),
                Contains("EX_IO[3] is on " + ball + ", no ball of the device"));
  }
}

TEST_F(Mistake, another_device_than_the_boards_is_found) {
  replace("boards/de2_115/device.csv", "EP4CE115F29C7", "EP4CE115F29C8");
  EXPECT_THAT(misplaced_in(folder_, "de2_115"),
              Contains("the board has another device: EP4CE115F29C7"));
}

}  // namespace
}  // namespace synthesis
