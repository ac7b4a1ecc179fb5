// SPDX-License-Identifier: Apache-2.0
// A machine whose drives have play and whose filament is loaded by commands: its firmware can be
// built, and what it does besides the lines is judged.
#include <gmock/gmock.h>

#include "directories.hpp"
#include "tests/scenarios/job.hpp"
#include "tools/files/file_text.hpp"

namespace {

constexpr const char* parts = R"(
[backlash]
x_mm = 0.2
y_mm = 0.1
z_mm = 0.05

[filament_sensor]
input = 6
low_is_out = false

[filament_change]
load_mm = 3
unload_mm = 2
load_speed_mm_s = 40
unload_speed_mm_s = 40
purge_mm = 1
purge_speed_mm_s = 10
)";

TEST(fitted_parts, print_to_the_step_with_backlash_and_moves_of_filament) {
  const auto machine = scenarios::scratch_folder() / "parts.toml";
  const std::string plain = PROJECT_DIRECTORY "/firmware/machines/bed_slinger.toml";
  scenarios::write_file(machine, files::text_of(plain) + parts);
  const scenarios::Print print = scenarios::print_text(
      "M104 S200\nG28\nM109 S200\nG1 X50 Y50 Z5 F6000\nG1 X30\nG1 X40 Y60 E1\nG1 X41 Z4\n"
      "M425 X0.1 F0.5\nG1 X30\nG2 I5 E2\nM701 Z1\nG1 X31 E3\nM702\nG1 X30 E4\nM400\n",
      {"--warm", "--machine", machine.string()});
  EXPECT_EQ(print.job.status, 0) << print.job.output;
  EXPECT_EQ(print.report["path"]["points_reached"], 13);
}

}  // namespace
