// SPDX-License-Identifier: Apache-2.0
// What the machine generator says of kinematics and a probe.
#include <gmock/gmock.h>

#include <filesystem>
#include <string>

#include "machine/machine.hpp"
#include "machine_generator/header.hpp"
#include "machine_generator/reader.hpp"
#include "tests/application/machine_complaints.hpp"
#include "tests/sim/changed_description.hpp"
#include "tests/temporary_folder.hpp"
#include "tools/files/file_text.hpp"

namespace {

using application_test::complaint;
using application_test::complaint_about;
using testing::HasSubstr;

TEST(machine_generator, names_kinematics_that_do_not_fit) {
  const std::string core_xy = "core_xy.toml", delta = "delta.toml";
  EXPECT_THAT(complaint("kinematics = \"cartesian\"", "kinematics = \"polar\""),
              HasSubstr("line 6: kinematics: must be \"cartesian\", \"core_xy\", \"delta\" or "
                        "\"scara\""));
  EXPECT_THAT(
      complaint_about(core_xy, "[axes.y]\nsteps_per_mm = 80.0", "[axes.y]\nsteps_per_mm = 100.0"),
      HasSubstr("axes.y.steps_per_mm: must be that of axes.x"));
  EXPECT_THAT(complaint_about(delta, "rod_length_mm = 250.0", "rod_length_mm = 199.0"),
              HasSubstr("delta.rod_length_mm: must be 1.053 times"));
  EXPECT_THAT(complaint_about(delta, "rod_length_mm = 250.0", "rod_length_mm = 1001.0"),
              HasSubstr("delta.rod_length_mm: is 1001, but must be 1 to 1000"));
  EXPECT_THAT(complaint_about(delta, "printable_radius_mm = 85.0", "printable_radius_mm = 105.0"),
              HasSubstr("delta.printable_radius_mm: must be below radius_mm"));
  EXPECT_THAT(complaint_about(delta, "[0.0, 0.0, 0.0]", "[0.0, 0.5, 0.0]"),
              HasSubstr("delta.end_stop_offset_mm: is 0.5"));
  EXPECT_THAT(complaint_about(delta, "[0.0, 0.0, 0.0]", "[0.0, 0.0]"),
              HasSubstr("delta.end_stop_offset_mm: must be a list of 3 numbers"));
  EXPECT_THAT(complaint_about(delta, "height_mm = 250.0", ""),
              HasSubstr("delta.height_mm: is missing"));
  EXPECT_THAT(complaint_about(delta, "memory_kib = 128", "memory_kib = 130"),
              HasSubstr("memory_kib: must be a multiple of 4"));
  EXPECT_THAT(complaint_about(delta, "memory_kib = 128", "memory_kib = 260"),
              HasSubstr("memory_kib: is 260, but must be 64 to 256"));
}

TEST(machine_generator, takes_a_probe_with_its_mesh) {
  const std::string header =
      machine_generator::header_of(PROJECT_DIRECTORY "/firmware/machines/probed_bed_slinger.toml");
  for (const char* value : {".input = 3", "units::Nanometers{-1200000}", ".levelling = &levelling",
                            ".first = units::Nanometers{25000000}", ".points = 5",
                            ".fade_height = units::Nanometers{10000000}"}) {
    EXPECT_THAT(header, HasSubstr(value));
  }
  EXPECT_EQ(machine::machine.levelling, nullptr);
}

TEST(machine_generator, names_what_a_probe_cannot_do) {
  const auto complaint_of = [](const std::string& from, const std::string& to) {
    return complaint_about("probed_bed_slinger.toml", from, to);
  };
  EXPECT_THAT(complaint_of("input = 3", "input = 2"),
              HasSubstr("probe.input: is the end stop of an axis already"));
  EXPECT_THAT(complaint_of("input = 3", "input = 8"), HasSubstr("probe.input: is 8"));
  EXPECT_THAT(complaint_of("clearance_mm = 4.0", "clearance_mm = 0.2"),
              HasSubstr("probe.clearance_mm: must be above deepest_mm less offset_z_mm"));
  EXPECT_THAT(complaint_of("deepest_mm = -1.0", "deepest_mm = 0.5"),
              HasSubstr("probe.deepest_mm: is 0.5"));
  EXPECT_THAT(complaint_of("min_x_mm = 25.0", "min_x_mm = 24.0"),
              HasSubstr("mesh.min_x_mm: is where the probe, by its offset, cannot be"));
  EXPECT_THAT(complaint_of("max_y_mm = 200.0", "max_y_mm = 211.0"),
              HasSubstr("mesh.max_y_mm: is where the probe, by its offset, cannot be"));
  EXPECT_THAT(complaint_of("max_x_mm = 205.0", "max_x_mm = 25.5"),
              HasSubstr("mesh.max_x_mm: must be 1 mm above min_x_mm at least"));
  EXPECT_THAT(complaint_of("points_x = 5", "points_x = 16"), HasSubstr("mesh.points_x: is 16"));
  EXPECT_THAT(complaint_of("points_y = 5", "points_y = 1"), HasSubstr("mesh.points_y: is 1"));
  EXPECT_THAT(complaint_of("middle_mm = -0.15", "middle_mm = 11.0"),
              HasSubstr("bed_surface.middle_mm: is 11"));
  EXPECT_THAT(complaint_of("backoff_mm = 1.0", ""), HasSubstr("probe.backoff_mm: is missing"));
  EXPECT_THAT(complaint("[drivers.a4988]", "[mesh]\n[drivers.a4988]"),
              HasSubstr("mesh: needs a table [probe]"));
  EXPECT_THAT(complaint_about("two_extruders.toml", "[tool_1]", "[probe]\ninput = 3\n[tool_1]"),
              HasSubstr("probe: a machine with [tool_1] cannot have one yet"));
}

TEST(machine_generator, takes_ramps_of_third_order) {
  EXPECT_THAT(machine_generator::header_of(PROJECT_DIRECTORY "/firmware/machines/core_xy.toml"),
              HasSubstr(".s_curve = true"));
  EXPECT_FALSE(machine::machine.limits.s_curve);
}

TEST(machine_generator, names_where_ramps_of_third_order_cannot_be) {
  const std::string on = "[motion]\ns_curve_acceleration = true";
  EXPECT_THAT(complaint("[motion]", on), testing::IsEmpty());
  EXPECT_THAT(complaint("[motion]", "[motion]\ns_curve_acceleration = 1"),
              HasSubstr("motion.s_curve_acceleration: must be true or false"));
  EXPECT_THAT(complaint_about("bed_slinger.toml", "[motion]", on),
              HasSubstr("line 58: motion.s_curve_acceleration: cannot be true in a machine with "
                        "[shaping]"));
  for (const char* machine : {"delta.toml", "scara.toml"}) {
    EXPECT_THAT(complaint_about(machine, "[motion]", on),
                HasSubstr("motion.s_curve_acceleration: cannot be true with these kinematics"));
  }
  for (const char* machine : {"probed_bed_slinger.toml", "two_extruders.toml"}) {
    EXPECT_THAT(complaint_about(machine, "[motion]", on), testing::IsEmpty());
  }
}

TEST(machine_generator, takes_the_arms_of_a_scara) {
  const std::string header =
      machine_generator::header_of(PROJECT_DIRECTORY "/firmware/machines/scara.toml");
  EXPECT_THAT(header, HasSubstr(".kinematics = motion::kinematics::Scara::Parameters{"));
  for (const char* value :
       {".proximal = units::Nanometers{200000000}, .distal = units::Nanometers{180000000}",
        ".shoulder_x = units::Nanometers{100000000}, .shoulder_y = units::Nanometers{-120000000}",
        ".elbow_left = false", ".home_y = units::Nanometers{60000000}",
        ".end_stop = {{units::Nanometers{100000000}, units::Nanometers{215000000}}}"}) {
    EXPECT_THAT(header, HasSubstr(value));
  }
}

TEST(machine_generator, names_arms_that_do_not_fit) {
  const auto expect = [](const std::string& from, const std::string& to, const char* what) {
    EXPECT_THAT(complaint_about("scara.toml", from, to), HasSubstr(what)) << to;
  };
  expect("proximal_mm = 200.0", "proximal_mm = 501.0",
         "line 15: scara.proximal_mm: is 501, but must be 10 to 500");
  expect("distal_mm = 180.0", "", "line 14: scara.distal_mm: is missing");
  expect("\"right\"", "\"up\"", "line 17: scara.elbow: must be \"left\" or \"right\"");
  expect("[100.0, -120.0]", "[100.0]", "line 18: scara.shoulder_mm: must be a list of 2 numbers");
  // 200^2 + 180^2 -+ 2 * 200 * 180 * cos 10 degrees, its root.
  expect("inner_radius_mm = 130.0", "inner_radius_mm = 38.6",
         "line 21: scara.inner_radius_mm: must be 38.650 at least: the arms would fold");
  expect("outer_radius_mm = 320.0", "outer_radius_mm = 378.6",
         "line 22: scara.outer_radius_mm: must be 378.558 at most: the arms would stretch");
  expect("outer_radius_mm = 320.0", "outer_radius_mm = 130.0",
         "line 21: scara.inner_radius_mm: must be below outer_radius_mm");
  // 119.9 mm from the shoulder; off the bed.
  expect("home_mm = [10.0, 60.0]", "home_mm = [100.0, 9.9]",
         "line 24: scara.home_mm: is out of reach");
  expect("home_mm = [10.0, 60.0]", "home_mm = [200.1, 60.0]",
         "line 24: scara.home_mm: is out of reach");
  // By the law of cosines: -8.999 at X200 Y0, 77.456 at X0 on the outer circle.
  expect("[100.0, 215.0]", "[78.0, 215.0]",
         "line 23: scara.end_stop_deg: lets the proximal arm turn from -47.0 to 78.0 degrees "
         "(travel_mm of axes.x), but the bed needs -9.0 to 77.5 and a degree of reserve");
  expect("[100.0, 215.0]", "[100.0, 236.0]",
         "line 23: scara.end_stop_deg: lets the distal arm turn from 106.0 to 236.0 degrees "
         "(travel_mm of axes.y), but the bed needs 106.4 to 202.4 and a degree of reserve");
  expect("travel_mm = 125.0", "travel_mm = 109.0",
         "lets the proximal arm turn from -9.0 to 100.0 degrees");
  EXPECT_THAT(complaint_about("scara.toml", "[100.0, 215.0]", "[79.0, 235.0]"), testing::IsEmpty());
  // A bed all about the shoulder needs whole turns.
  expect("[100.0, -120.0]  # in the bed's coordinates\nbed_mm = [200.0, 200.0]",
         "[150.0, 150.0]\nbed_mm = [300.0, 300.0]",
         "line 23: scara.end_stop_deg: lets the proximal arm turn from -25.0 to 100.0 degrees");
}

// With a table in front of the drivers'.
std::string complaint_of_table(const std::string& text) {
  return complaint("[drivers.a4988]", text + "\n[drivers.a4988]");
}

TEST(machine_generator, takes_backlash_and_what_is_known_of_filament) {
  const TemporaryFolder folder;
  folder.write("machine.toml",
               tests::changed_description(
                   "[drivers.a4988]",
                   "[backlash]\nx_mm = 0.12\ny_mm = 0.1\nz_mm = 0\ncorrection = 0.75\n"
                   "[filament_sensor]\ninput = 5\nlow_is_out = true\n"
                   "[filament_change]\nload_mm = 420\nunload_mm = 450\nload_speed_mm_s = 25\n"
                   "unload_speed_mm_s = 50\npurge_mm = 30\npurge_speed_mm_s = 3\n[drivers.a4988]"));
  const std::string header = machine_generator::header_of(folder.path() / "machine.toml");
  for (const char* value :
       {".lengths = {{units::Nanometers{120000}, units::Nanometers{100000}, units::Nanometers{0}, "
        "}}, .correction = 750000",
        ".backlash = &backlash", ".input = 5, .low_is_out = true",
        ".filament_sensor = &filament_sensor", ".load = units::Nanometers{420000000}",
        ".purge_speed = units::MicrometersPerSecond{3000}",
        ".filament_change = &filament_change"}) {
    EXPECT_THAT(header, HasSubstr(value));
  }
  EXPECT_EQ(machine::machine.backlash, nullptr);
  EXPECT_FALSE(machine::machine.handles_filament());
}

TEST(machine_generator, names_backlash_that_cannot_be) {
  EXPECT_THAT(complaint_of_table("[backlash]\nx_mm = 5.1\ny_mm = 0\nz_mm = 0"),
              HasSubstr("backlash.x_mm: is 5.1, but must be 0 to 5"));
  EXPECT_THAT(complaint_of_table("[backlash]\nx_mm = 0.1\ny_mm = -0.1\nz_mm = 0"),
              HasSubstr("backlash.y_mm: is -0.1"));
  EXPECT_THAT(complaint_of_table("[backlash]\nx_mm = 0.1\ny_mm = 0.1"),
              HasSubstr("backlash.z_mm: is missing"));
  EXPECT_THAT(complaint_of_table("[backlash]\nx_mm = 0.1\ny_mm = 0.1\nz_mm = 0\ncorrection = 1.5"),
              HasSubstr("backlash.correction: is 1.5, but must be 0 to 1"));
  for (const char* machine : {"core_xy.toml", "delta.toml", "scara.toml"}) {
    EXPECT_THAT(complaint_about(machine, "[motion]",
                                "[backlash]\nx_mm = 0.1\ny_mm = 0.1\nz_mm = 0\n[motion]"),
                HasSubstr("backlash: needs kinematics = \"cartesian\""));
  }
}

TEST(machine_generator, names_a_filament_sensor_and_lengths_that_cannot_be) {
  EXPECT_THAT(complaint_of_table("[filament_sensor]\ninput = 2\nlow_is_out = true"),
              HasSubstr("filament_sensor.input: is the end stop of an axis already"));
  EXPECT_THAT(complaint_of_table("[filament_sensor]\ninput = 8\nlow_is_out = true"),
              HasSubstr("filament_sensor.input: is 8"));
  EXPECT_THAT(complaint_of_table("[filament_sensor]\ninput = 3"),
              HasSubstr("filament_sensor.low_is_out: is missing"));
  EXPECT_THAT(complaint_about("probed_bed_slinger.toml", "[motion]",
                              "[filament_sensor]\ninput = 3\nlow_is_out = false\n[motion]"),
              HasSubstr("filament_sensor.input: is that of the probe already"));
  EXPECT_THAT(complaint_of_table("[filament_change]\nload_mm = 2001"),
              HasSubstr("filament_change.load_mm: is 2001, but must be 0 to 2000"));
}

}  // namespace
