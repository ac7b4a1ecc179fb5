// SPDX-License-Identifier: Apache-2.0
// A sensor or a heater that fails in a print: the print ends with the fault's name, and the block
// is no hotter than promised.
#include <gmock/gmock.h>

#include <string>

#include "tests/scenarios/job.hpp"

namespace {

using scenarios::print_text;

// The target is held when the part breaks.
void expect_fault(const std::string& heater, const std::string& gcode, const std::string& fault,
                  const std::string& name, double at_most) {
  const auto print = print_text(gcode, {"--warm", "--fault", heater + "-" + fault});
  EXPECT_EQ(print.job.status, 1) << print.job.output;
  EXPECT_EQ(print.report["result"], "faulted");
  EXPECT_TRUE(print.said(name)) << print.job.output;
  EXPECT_LT(print.report[heater]["max_c"].get<double>(), at_most);
}

void expect_hotend_fault(const std::string& fault, const std::string& name) {
  expect_fault("hotend", "M109 S205\nG4 S150\nG28 X\n", fault, name, 235);
}
void expect_bed_fault(const std::string& fault, const std::string& name) {
  expect_fault("bed", "M190 S60\nG4 S550\nG28 X\n", fault, name, 75);
}

TEST(heat_faults, a_frozen_hotend_sensor_ends_the_print) {
  expect_hotend_fault("frozen@30", "thermistor frozen");
}
// After a minute of heat: sooner after a warm start it looks like a weak heater in
// much wind (firmware/thermal/faults.md).
TEST(heat_faults, a_drifting_hotend_sensor_ends_the_print) {
  expect_hotend_fault("drifting@60", "Thermal Runaway");
}
// From cold, before anything is known of the heater.
TEST(heat_faults, a_hotend_sensor_that_drifts_while_it_heats_up_ends_the_print) {
  const auto print = print_text("M109 S205\nG28 X\n", {"--fault", "hotend-drifting@5"});
  EXPECT_EQ(print.job.status, 1) << print.job.output;
  EXPECT_EQ(print.report["result"], "faulted");
  EXPECT_TRUE(print.said("Heating failed")) << print.job.output;
  EXPECT_LT(print.report["hotend"]["max_c"].get<double>(), 80);
}
TEST(heat_faults, a_detached_hotend_sensor_ends_the_print) {
  expect_hotend_fault("detached@30", "Thermal Runaway");
}
TEST(heat_faults, a_hotend_heater_that_sticks_ends_the_print) {
  expect_hotend_fault("heater-stuck-on@30", "heats while off");
}
TEST(heat_faults, a_frozen_bed_sensor_ends_the_print) {
  expect_bed_fault("frozen@60", "thermistor frozen");
}
TEST(heat_faults, a_drifting_bed_sensor_ends_the_print) {
  expect_bed_fault("drifting@60", "Thermal Runaway");
}
TEST(heat_faults, a_detached_bed_sensor_ends_the_print) {
  expect_bed_fault("detached@60", "Thermal Runaway");
}
TEST(heat_faults, a_bed_heater_that_sticks_ends_the_print) {
  expect_bed_fault("heater-stuck-on@60", "heats while off");
}

}  // namespace
