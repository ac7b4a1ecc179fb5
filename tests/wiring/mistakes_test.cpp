// SPDX-License-Identifier: Apache-2.0
// Each kind of mistake in the interface board's description, in what it must agree with, or in the
// files that are made of it, is found.
#include <gmock/gmock.h>

#include <fstream>

#include "directories.hpp"
#include "tools/files/file_text.hpp"
#include "tools/process/process.hpp"

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::string generator = BUILD_DIRECTORY "/bin/wiring_generator";

// A copy of all that the description must agree with.
class WiringMistake : public testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    for (const char* part : {"boards", "constraints", "firmware/machines"}) copy(part);
    for (const char* file : {"firmware/application/heat_task.cpp", "rtl/thermal/protection.md",
                             "rtl/thermal/temperature_converter.toml",
                             "sim/devices/thermistor_input.hpp", "tests/synthesis/pin_needs.cpp"}) {
      copy(file);
    }
  }
  void TearDown() override { fs::remove_all(folder_); }

  void copy(const fs::path& part) const {
    fs::create_directories((folder_ / part).parent_path());
    fs::copy(fs::path(PROJECT_DIRECTORY) / part, folder_ / part, fs::copy_options::recursive);
  }

  // Puts a mistake in, lets the generator look for it, and takes it out.
  void expect_found(const char* file, const std::string& good, const std::string& bad,
                    const std::string& complaint) const {
    const std::string text = files::text_of(folder_ / file);
    const std::size_t place = text.find(good);
    ASSERT_NE(place, std::string::npos) << good;
    std::string changed = text;
    std::ofstream(folder_ / file) << changed.replace(place, good.size(), bad);
    const auto [status, words] =
        process::capture({.arguments = {generator, "--project", folder_, "--check"}});
    EXPECT_NE(status, 0) << bad;
    EXPECT_THAT(words, HasSubstr(complaint)) << bad;
    std::ofstream(folder_ / file) << text;
  }

  static constexpr const char* circuits = "boards/interface/interface.toml";
  static constexpr const char* values = "boards/interface/values.toml";
  const fs::path folder_ = fs::path(testing::TempDir()) / "stepfabric wiring test";
};

TEST_F(WiringMistake, there_is_none_in_the_description_as_it_is) {
  const auto [status, words] =
      process::capture({.arguments = {generator, "--project", folder_, "--check"}});
  EXPECT_EQ(status, 0) << words;
}

TEST_F(WiringMistake, a_net_left_out_is_found) {
  expect_found(circuits, R"(pins = ["heater_#_gate", "GND"])", R"(pins = ["heater_#_gate", ""])",
               "R202.2 is not connected");
  expect_found(circuits, R"(pins = ["heater_#_gate", "GND"])", R"(pins = ["heater_#_gate"])",
               "a resistor has 2 pins; 1 are connected");
  expect_found(circuits, R"("direction[0]",)", R"("",)", "header position 20: a net");
}

TEST_F(WiringMistake, a_net_with_one_pin_is_found) {
  expect_found(circuits, R"(["+12V", "relay_coil"])", R"(["+12V", "relay_coi"])",
               "D301.2 alone is connected to relay_coi");
  expect_found(circuits, R"(pins = ["+HEAT", "heater_#_high"])",
               R"(pins = ["heater_#_high", "heater_#_high"])", "F201 is bridged");
}

TEST_F(WiringMistake, a_pin_that_is_used_twice_is_found) {
  expect_found(circuits, R"("step[1]")", R"("step[0]")",
               "step[0] is at header positions 19 and 22");
  expect_found(circuits, R"(ref = "R2", kind = "resistor", value = "stop_pull_up")",
               R"(ref = "R1", kind = "resistor", value = "stop_pull_up")",
               "two parts are called R701");
  expect_found(circuits, "first = 700", "first = 600", "two parts are called R601");
}

TEST_F(WiringMistake, a_value_that_is_changed_is_found) {
  expect_found(values, "value = 1500", "value = 4700",
               "gate_pull_down: gate against the strongest pull-up is 1.31 V, must be at most");
  expect_found(values, "value = 1500", "value = 1400", "gate_pull_down is 1400 here, 1500 in");
  expect_found(values, "value = 68e-9", "value = 10e-9",
               "sensor_capacitor is 1e-08 here, 6.8e-08 in temperature_converter.capacitor_nf");
  expect_found(values, "value = 68e-9", "value = 10e-9", "against the shortest cut-off is 1.17 µs");
  expect_found(values, "value = 15\n", "value = 10\n", "bed_fuse: of the heater's current is 1");
  expect_found(values, "value = 470\n", "value = 330\n", "reference_low: current out of the pin");
}

TEST_F(WiringMistake, a_contradiction_to_another_place_is_found) {
  expect_found("firmware/machines/prusa_mendel.toml", "heater_watts = 120.0",
               "heater_watts = 200.0", "bed_power is 120 here, 200 in bed.heater_watts");
  expect_found("constraints/signals.csv", "pad,3.3,up,4700", "pad,3.3,up,3300",
               "enable_pull_up is 4700 here, 3300 in motor_enable_n");
  expect_found("firmware/application/heat_task.cpp", "charge_margin = 2;", "charge_margin = 20;",
               "it does not say \"charge_margin = 2;\"");
  expect_found("tests/synthesis/pin_needs.cpp", "strongest_cyclone_pull_ohms = 7e3",
               "strongest_cyclone_pull_ohms = 5e3", "cyclone_pull: ");
}

TEST_F(WiringMistake, a_board_that_is_wired_otherwise_is_found) {
  expect_found("boards/de2_115/connections.csv", "fan_gate,GPIO[32]\nheater_supply,GPIO[33]",
               "fan_gate,GPIO[33]\nheater_supply,GPIO[32]",
               "de2_115: fan_gate is at position 38, where the interface board has heater_supply");
  expect_found("boards/de2_70/connections.csv", "end_stop[7],GPIO_0[13]\n", "",
               "de2_70: end_stop[7] does not come from the board");
  expect_found("boards/ulx3s/connections.csv", "step[4],gp[4]\n", "step[5],gp[4]\n",
               "ulx3s: step[5] is not on the interface board");
  const char* const of_2012 = "boards/de2_70_reprap_2012/connections.csv";
  expect_found(of_2012, "step[0],GPIO_0[6]\n", "",
               "nothing leads to M2(X)_step of the printer, position 9");
  expect_found("boards/de2_70/reprap_2012_pins.csv", "M3(Y)_step,12,F30,17", "M3(Y)_step,12,F30,18",
               "step[1] is at position 17, where the printer has");
}

TEST_F(WiringMistake, a_file_that_is_not_as_the_description_is_found) {
  expect_found("boards/interface/interface.net", "(pin \"13\")", "(pin \"14\")",
               "interface.net is stale");
  expect_found("boards/interface/parts.csv", "1.5 kΩ", "15 kΩ", "parts.csv is stale");
  expect_found("boards/interface/schematic.svg", "4.7 kΩ", "47 kΩ", "schematic.svg is stale");
  expect_found("boards/de2_115/wiring.svg", "AB22", "AB21", "de2_115/wiring.svg is stale");
  // A pin table that changes makes its picture stale.
  expect_found("boards/ulx3s/connections.csv", "fan_gate,gn[9]", "fan_gate,gn[23]",
               "ulx3s/wiring.svg is stale");
}

TEST_F(WiringMistake, a_description_of_another_form_is_refused) {
  expect_found(circuits, "turn = 90", "turned = 90", "unknown entry 'turned'");
  expect_found(circuits, "kind = \"fuse\"", "kind = \"fuze\"", "there is no 'fuze'");
  expect_found(circuits, "[header]", "[header", "interface.toml: line");
  expect_found(values, "formula = \"pin_resistance + series\"", "formula = \"pin + series\"",
               "series: formula \"pin + series\": pin has no value");
  expect_found("boards/interface/facts.toml", "name = \"coil\"", "name = \"gain\"",
               "gain is said twice");
}

}  // namespace
