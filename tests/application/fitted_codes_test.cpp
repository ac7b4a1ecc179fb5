// SPDX-License-Identifier: Apache-2.0
// Codes that slicers and hosts send, on each of the machines: known, and called not fitted exactly
// where the machine does not have the part.
#include <gtest/gtest.h>

#include <optional>
#include <set>
#include <string>
#include <variant>

#include "tests/application/described_machine.hpp"

namespace application_test {
namespace {

const std::set<std::string> codes{"G0",
                                  "G1",
                                  "G2",
                                  "G3",
                                  "G4",
                                  "G10",
                                  "G11",
                                  "G17",
                                  "G18",
                                  "G19",
                                  "G20",
                                  "G21",
                                  "G27",
                                  "G28",
                                  "G29",
                                  "G30",
                                  "G53",
                                  "G54",
                                  "G55",
                                  "G56",
                                  "G57",
                                  "G58",
                                  "G59",
                                  "G59.1",
                                  "G59.2",
                                  "G59.3",
                                  "G60",
                                  "G61",
                                  "G90",
                                  "G91",
                                  "G92",
                                  "G92.1",
                                  "M0",
                                  "M1",
                                  "M17",
                                  "M18",
                                  "M31",
                                  "M42",
                                  "M73",
                                  "M75",
                                  "M76",
                                  "M77",
                                  "M78",
                                  "M82",
                                  "M83",
                                  "M84",
                                  "M85",
                                  "M86",
                                  "M92",
                                  "M104",
                                  "M105",
                                  "M106",
                                  "M107",
                                  "M108",
                                  "M109",
                                  "M110",
                                  "M111",
                                  "M112",
                                  "M113",
                                  "M114",
                                  "M115",
                                  "M117",
                                  "M118",
                                  "M119",
                                  "M120",
                                  "M121",
                                  "M122",
                                  "M140",
                                  "M143",
                                  "M149",
                                  "M154",
                                  "M155",
                                  "M190",
                                  "M200",
                                  "M201",
                                  "M203",
                                  "M204",
                                  "M205",
                                  "M206",
                                  "M207",
                                  "M208",
                                  "M209",
                                  "M211",
                                  "M217",
                                  "M218",
                                  "M220",
                                  "M221",
                                  "M226",
                                  "M240",
                                  "M280",
                                  "M290",
                                  "M300",
                                  "M301",
                                  "M302",
                                  "M303",
                                  "M304",
                                  "M400",
                                  "M410",
                                  "M412",
                                  "M413",
                                  "M420",
                                  "M425",
                                  "M428",
                                  "M500",
                                  "M501",
                                  "M502",
                                  "M503",
                                  "M504",
                                  "M524",
                                  "M540",
                                  "M569",
                                  "M572",
                                  "M575",
                                  "M593",
                                  "M600",
                                  "M603",
                                  "M605",
                                  "M665",
                                  "M666",
                                  "M701",
                                  "M702",
                                  "M851",
                                  "M862.1",
                                  "M862.2",
                                  "M862.3",
                                  "M862.4",
                                  "M862.5",
                                  "M862.6",
                                  "M876",
                                  "M900",
                                  "M906",
                                  "M914",
                                  "M997",
                                  "M999",
                                  "T0",
                                  "T1",
                                  "EXCLUDE_OBJECT NAME=a",
                                  "M486 S0"};

// Of no machine, with the parts that some machines have.
std::set<std::string> not_fitted(const application::MachineDescription& machine) {
  std::set<std::string> list{"M42",    "M143",   "M226",   "M240", "M280",   "M301",   "M303",
                             "M304",   "M413",   "M569",   "M575", "M862.1", "M862.2", "M862.3",
                             "M862.4", "M862.5", "M862.6", "M906", "M914"};
  const auto needs = [&list](bool fitted, std::initializer_list<const char*> of_part) {
    if (!fitted) list.insert(of_part.begin(), of_part.end());
  };
  needs(machine.levels(), {"G29", "G30", "M420", "M851"});
  needs(machine.tools() > 1, {"M217", "M218", "M605"});
  needs(machine.shaping.has_value(), {"M572", "M593", "M900"});
  needs(machine.backlash != nullptr, {"M425"});
  needs(machine.filament_sensor != nullptr, {"M412"});
  needs(machine.filament_change != nullptr, {"M603", "M701", "M702"});
  needs(std::holds_alternative<motion::kinematics::Delta::Parameters>(machine.kinematics),
        {"M665", "M666"});
  return list;
}

class FittedCodes : public testing::TestWithParam<const char*> {};

TEST_P(FittedCodes, are_known_and_called_not_fitted_only_where_they_are_not) {
  const application::MachineDescription machine = described_machine(GetParam());
  const auto absent = not_fitted(machine);
  std::optional<Printer> printer;
  for (const std::string& code : codes) {
    if (!printer) {
      printer.emplace(machine);
      printer->reply();  // the greeting
    }
    printer->send(code);
    std::string answer, line;
    do {
      line = printer->reply(0.1).value_or("");
      answer += line + "\n";
    } while (line != "ok" && !line.empty());
    EXPECT_EQ(answer.find("Unknown command"), std::string::npos) << code;
    EXPECT_EQ(answer.find("not fitted") != std::string::npos, absent.contains(code))
        << code << ": " << answer;
    if (line != "ok") {
      printer.reset();  // it waits, or has halted
    }
  }
}

INSTANTIATE_TEST_SUITE_P(machines, FittedCodes,
                         testing::Values("prusa_mendel", "bed_slinger", "probed_bed_slinger",
                                         "core_xy", "delta", "scara", "two_extruders"),
                         [](const auto& each) { return std::string(each.param); });

}  // namespace
}  // namespace application_test
