// SPDX-License-Identifier: Apache-2.0
// The machine generator takes the given machine exactly, and names every mistake in a description.
#include <gmock/gmock.h>

#include <cstdio>
#include <fstream>
#include <sstream>

#include "machine/machine.hpp"
#include "machine_generator/header.hpp"
#include "machine_generator/reader.hpp"

namespace {

using testing::HasSubstr;

std::string given_description() {
  std::ifstream file(std::string(PROJECT_DIRECTORY) + "/firmware/machines/prusa_mendel.toml");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// What the generator says about the given description with one text replaced by another.
std::string complaint(const std::string& from, const std::string& to) {
  std::string text = given_description();
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  const std::string name = testing::TempDir() + "changed_machine.toml";
  std::ofstream(name) << text;
  try {
    machine_generator::header_of(name);
  } catch (const machine_generator::DescriptionError& error) {
    std::remove(name.c_str());
    return error.what();
  }
  std::remove(name.c_str());
  return "";
}

TEST(machine_generator, keeps_the_numbers_of_the_given_machine) {
  const auto& limits = machine::machine.limits;
  EXPECT_EQ(limits.of(units::Axis::x).steps_per_meter.count(), 80'000);
  EXPECT_EQ(limits.of(units::Axis::z).steps_per_meter.count(), 2'560'000);
  EXPECT_EQ(limits.of(units::Axis::y).travel.count(), 200'000'000);
  EXPECT_EQ(limits.of(units::Axis::z).homing->slow_speed.count(), 1'000);
  EXPECT_FALSE(limits.of(units::Axis::e).homing.has_value());
  EXPECT_EQ(machine::machine.hotend.max.count(), 275'000);
  EXPECT_EQ(machine::machine.converter.capacitor_picofarads, 68'000);
  EXPECT_EQ(machine::machine.baud, 250'000u);
}

TEST(machine_generator, names_what_is_missing) {
  EXPECT_THAT(complaint("travel_mm = 110.0", ""), HasSubstr("axes.z.travel_mm: is missing"));
}

TEST(machine_generator, names_what_it_does_not_know) {
  EXPECT_THAT(complaint("baud = 250_000", "baud = 250_000\nparity = 1"),
              HasSubstr("serial.parity: is not an entry"));
}

TEST(machine_generator, names_what_has_the_wrong_type) {
  EXPECT_THAT(complaint("baud = 250_000", "baud = \"fast\""),
              HasSubstr("serial.baud: must be a whole number"));
  EXPECT_THAT(complaint("advanced_ok = false", "advanced_ok = 0"),
              HasSubstr("serial.advanced_ok: must be true or false"));
  EXPECT_THAT(complaint("max_c = 275.0", "max_c = true"),
              HasSubstr("hotend.max_c: must be a number"));
}

TEST(machine_generator, names_what_is_out_of_range) {
  EXPECT_THAT(complaint("steps_per_mm = 80.0", "steps_per_mm = 0.0"),
              HasSubstr("axes.x.steps_per_mm: is 0, but must be"));
  EXPECT_THAT(complaint("steps_per_mm = 80.0", "steps_per_mm = nan"),
              HasSubstr("axes.x.steps_per_mm"));
  EXPECT_THAT(complaint("steps_per_mm = 80.0", "steps_per_mm = 80.00001"), HasSubstr("finer"));
}

TEST(machine_generator, names_references_to_nothing) {
  EXPECT_THAT(complaint("driver = \"a4988\"", "driver = \"a4989\""),
              HasSubstr("axes.x.driver: names none of [drivers]"));
  EXPECT_THAT(complaint("thermistor = \"ntc100k\"", "thermistor = \"ntc\""),
              HasSubstr("hotend.thermistor: names none of [thermistors]"));
  EXPECT_THAT(complaint("endstop = 1", "endstop = 0"),
              HasSubstr("axes.y.endstop: is the input of another"));
}

TEST(machine_generator, says_the_line_of_broken_toml) {
  EXPECT_THAT(complaint("[serial]", "[serial"), HasSubstr("line "));
}

}  // namespace
