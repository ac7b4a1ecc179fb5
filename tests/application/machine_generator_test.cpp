// SPDX-License-Identifier: Apache-2.0
// The machine generator takes the given machine exactly, and names every mistake in a description.
#include <gmock/gmock.h>
#include <sys/stat.h>

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

void expect_complaints(std::initializer_list<tests::Mistake> mistakes) {
  tests::expect_complaints_of(machine_generator::header_of, mistakes);
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
  expect_complaints({{"travel_mm = 110.0", "", "axes.z.travel_mm: is missing"}});
}

TEST(machine_generator, takes_a_retraction_or_marlins) {
  EXPECT_EQ(machine::machine.limits.retraction.length.count(), 3'000'000);
  EXPECT_EQ(machine::machine.limits.retraction.recovery_speed.count(), 8'000);
  const auto with = [](const std::string& values) {
    return tests::changed_description("[drivers.a4988]",
                                      "[retraction]\n" + values + "\n[drivers.a4988]");
  };
  const TemporaryFolder folder;
  folder.write("machine.toml", with("length_mm = 0.8\nspeed_mm_s = 35.25\nlift_mm = 0.2\n"
                                    "extra_mm = -0.05\nrecovery_speed_mm_s = 30.5"));
  const std::string header = machine_generator::header_of(folder.path() / "machine.toml");
  for (const char* value :
       {".length = units::Nanometers{800000}", ".extra = units::Nanometers{-50000}",
        ".lift = units::Nanometers{200000}", "PerSecond{35250}", "PerSecond{30500}"}) {
    EXPECT_THAT(header, HasSubstr(value));
  }
  EXPECT_THAT(tests::complaint_of(machine_generator::header_of, with("length_mm = 0.8")),
              HasSubstr("retraction.speed_mm_s: is missing"));
  EXPECT_THAT(tests::complaint_of(machine_generator::header_of,
                                  with("length_mm = -1\nspeed_mm_s = 35\nlift_mm = 0\n"
                                       "extra_mm = 0\nrecovery_speed_mm_s = 30")),
              HasSubstr("retraction.length_mm: is -1"));
}

TEST(machine_generator, names_what_it_does_not_know) {
  expect_complaints(
      {{"baud = 250_000", "baud = 250_000\nparity = 1", "serial.parity: is not an entry"}});
}

TEST(machine_generator, names_what_has_the_wrong_type) {
  expect_complaints(
      {{"baud = 250_000", "baud = \"fast\"", "serial.baud: must be a whole number"},
       {"advanced_ok = false", "advanced_ok = 0", "serial.advanced_ok: must be true or false"},
       {"max_c = 275.0", "max_c = true", "hotend.max_c: must be a number"}});
}

TEST(machine_generator, names_what_is_out_of_range) {
  expect_complaints(
      {{"steps_per_mm = 80.0", "steps_per_mm = 0.0", "axes.x.steps_per_mm: is 0, but must be"},
       {"steps_per_mm = 80.0", "steps_per_mm = nan", "axes.x.steps_per_mm"},
       {"steps_per_mm = 80.0", "steps_per_mm = 80.00001", "finer"}});
}

// More digits than the binary form of a decimal number has.
TEST(machine_generator, names_whole_numbers_out_of_range) {
  for (const char* number : {"9223372036854775807", "-9223372036854775807", "9007199254740993"}) {
    EXPECT_THAT(complaint("min_c = 5.0", std::string("min_c = ") + number),
                HasSubstr("hotend.min_c: is"))
        << number;
    EXPECT_THAT(complaint("homing_speed_mm_s = 50.0", std::string("homing_speed_mm_s = ") + number),
                HasSubstr("axes.x.homing_speed_mm_s: is"))
        << number;
  }
}

TEST(machine_generator, refuses_a_clock_that_is_too_slow_for_the_serial_line) {
  const std::string from = "kinematics = \"cartesian\"\n\n[serial]\nbaud = 250_000";
  const auto complaint_at = [&](const std::string& mhz, const std::string& baud) {
    return complaint(
        from, "kinematics = \"cartesian\"\nclock_mhz = " + mhz + "\n\n[serial]\nbaud = " + baud);
  };
  EXPECT_THAT(complaint_at("4", "3_000_000"),
              HasSubstr("clock_mhz: is too slow for a serial line of 3000000 baud, which needs 4 "
                        "clocks for each bit: 12 at least, or a slower line"));
  EXPECT_THAT(complaint_at("4", "1_000_000"), testing::IsEmpty());
  EXPECT_THAT(complaint_at("12.5", "3_000_000"), testing::IsEmpty());
  EXPECT_THAT(complaint_at("0.5", "9_600"), HasSubstr("clock_mhz: is 0.5, but must be 4 to 200"));
}

// It becomes a text of the firmware, which sends it to hosts in one line.
TEST(machine_generator, names_a_name_that_is_no_line_of_ascii) {
  for (const char* name :
       {R"("a\"b")", R"("a\\")", R"("a\nok")", R"("a\u0000b")", R"("caf\u00e9")"}) {
    EXPECT_THAT(complaint("\"Prusa Mendel\"", name),
                HasSubstr("name: is longer than 64 bytes, or holds"))
        << name;
  }
  const std::string line(64, 'a');
  EXPECT_THAT(complaint("\"Prusa Mendel\"", '"' + line + "a\""), HasSubstr("name: is longer"));
  EXPECT_THAT(complaint("\"Prusa Mendel\"", '"' + line + '"'), testing::IsEmpty());
}

TEST(machine_generator, names_references_to_nothing) {
  expect_complaints(
      {{"driver = \"a4988\"", "driver = \"a4989\"", "axes.x.driver: names none of [drivers]"},
       {"thermistor = \"ntc100k\"", "thermistor = \"ntc\"",
        "hotend.thermistor: names none of [thermistors]"},
       {"endstop = 1", "endstop = 0", "axes.y.endstop: is the input of another"}});
}

// The number of channels and inputs is limited, and each may be used once.
TEST(machine_generator, names_channels_that_are_not_there_or_taken) {
  expect_complaints({{"heater_channel = 0", "heater_channel = 40",
                      "hotend.heater_channel: is 40, but must be 0 to 3"},
                     {"sensor_channel = 1", "sensor_channel = 0",
                      "bed.sensor_channel: is the channel of another heater"},
                     {"heater_channel = 1", "heater_channel = 0",
                      "bed.heater_channel: is the channel of another heater"}});
}

TEST(machine_generator, names_values_that_contradict_each_other) {
  expect_complaints({{"min_c = 5.0", "min_c = 275.0", "hotend.min_c: must be below max_c"},
                     {"min_extrusion_c = 170.0", "min_extrusion_c = 280.0",
                      "hotend.min_extrusion_c: must not be above max_c"},
                     {"reference_low_ohms = 470.0", "reference_low_ohms = 10_000.0",
                      "temperature_converter.reference_low_ohms: must be below"},
                     {"threshold_v = 1.65", "threshold_v = 3.3",
                      "temperature_converter.threshold_v: must be below supply_v"}});
}

// Entries that only the simulation uses are checked as well.
TEST(machine_generator, names_a_heater_without_power) {
  expect_complaints(
      {{"heater_watts = 40.0", "heater_watts = 0.0", "hotend.heater_watts: is 0, but must be"}});
}

TEST(machine_generator, says_the_line_of_a_wrong_entry) {
  expect_complaints({{"baud = 250_000", "\n\nbaud = 0",
                      "changed_machine.toml: line 11: serial.baud: is 0, but must be 1200 to"}});
  // Where an entry is missing, that of its table.
  expect_complaints({{"baud = 250_000", "", "line 8: serial.baud: is missing"}});
}

TEST(machine_generator, says_the_line_of_broken_toml) {
  expect_complaints({{"[serial]", "[serial", "line "}});
}

// An endless file is not read to its end.
TEST(machine_generator, takes_only_files_of_a_bounded_size) {
  const auto complaint_of_file = [](const std::filesystem::path& file) {
    try {
      machine_generator::Reader::parse(file);
    } catch (const machine_generator::DescriptionError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const TemporaryFolder folder;
  const std::filesystem::path pipe = folder.path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const std::filesystem::path& file :
       {std::filesystem::path("/dev/zero"), pipe, folder.path()}) {
    EXPECT_EQ(complaint_of_file(file), file.string() + ": is not a regular file");
  }
  EXPECT_EQ(complaint_of_file(folder.path() / "none"),
            (folder.path() / "none").string() + ": cannot be read");

  constexpr std::size_t most = std::size_t{1} << 20;
  const std::filesystem::path large = folder.path() / "large.toml";
  folder.write(large, std::string(most, '\n'));
  EXPECT_EQ(complaint_of_file(large), "");
  folder.write(large, std::string(most + 1, '\n'));
  EXPECT_EQ(complaint_of_file(large), large.string() + ": is larger than 1 MiB");
}

TEST(machine_generator, takes_every_machine_of_the_project) {
  for (const auto& entry :
       std::filesystem::directory_iterator(PROJECT_DIRECTORY "/firmware/machines")) {
    if (entry.path().extension() != ".toml") continue;
    EXPECT_NO_THROW(machine_generator::header_of(entry.path())) << entry.path();
  }
  const std::string header =
      machine_generator::header_of(PROJECT_DIRECTORY "/firmware/machines/delta.toml");
  EXPECT_THAT(header, HasSubstr(".kinematics = motion::kinematics::Delta::Parameters{"));
  EXPECT_THAT(header, HasSubstr("{.x = units::Nanometers{0}, .y = units::Nanometers{105000000}}"));
}

TEST(machine_generator, takes_a_second_extruder) {
  const std::string header =
      machine_generator::header_of(PROJECT_DIRECTORY "/firmware/machines/two_extruders.toml");
  for (const char* value :
       {".second_tool = application::SecondTool{", ".sensor_channel = 2, .heater_channel = 2",
        ".offset = {units::Nanometers{18000000}, units::Nanometers{500000}, units::Nanometers{0}}",
        ".swap = units::Nanometers{4000000}", ".lift = units::Nanometers{1000000}",
        ".retract_speed = units::MicrometersPerSecond{40000}"}) {
    EXPECT_THAT(header, HasSubstr(value));
  }
  EXPECT_THAT(machine_generator::header_of(PROJECT_DIRECTORY "/firmware/machines/delta.toml"),
              testing::Not(HasSubstr("second_tool")));
}

TEST(machine_generator, names_mistakes_in_a_second_extruder) {
  const std::string machine = "two_extruders.toml";
  EXPECT_THAT(complaint_about(machine, "[18.0, 0.5, 0.0]", "[18.0, 0.5]"),
              HasSubstr("tool_1.offset_mm: must be a list of 3 numbers"));
  EXPECT_THAT(complaint_about(machine, "[18.0, 0.5, 0.0]", "[1800.0, 0.5, 0.0]"),
              HasSubstr("tool_1.offset_mm: is 1800, but must be -1000 to 1000"));
  EXPECT_THAT(complaint_about(machine, "sensor_channel = 2", "sensor_channel = 1"),
              HasSubstr("tool_1.hotend.sensor_channel: is the channel of another heater already"));
  EXPECT_THAT(complaint_about(machine, "heater_channel = 2", "heater_channel = 0"),
              HasSubstr("tool_1.hotend.heater_channel: is the channel of another heater already"));
  EXPECT_THAT(complaint_about(machine, "lift_mm = 1.0", "lift_mm = -1.0"),
              HasSubstr("tool_change.lift_mm: is -1, but must be 0 to 200"));
  EXPECT_THAT(complaint_about(machine, "[tool_1.hotend.control]", "[tool_1.hotend.gains]"),
              HasSubstr("tool_1.hotend.control: is missing"));
  EXPECT_THAT(complaint_about(machine, "[tool_change]", "[change_of_tools]"),
              HasSubstr("tool_change: is missing"));
  EXPECT_THAT(complaint_about(machine, "offset_mm", "offsets_mm"),
              HasSubstr("tool_1.offset_mm: is missing"));
}

}  // namespace
