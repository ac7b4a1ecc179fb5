// SPDX-License-Identifier: Apache-2.0
// The chip with its firmware measures what an input costs.
#include "tools/worst_inputs/rig.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tests/default_machine.hpp"
#include "tests/loaded_printer.hpp"
#include "tools/worst_inputs/starts.hpp"

namespace worst_inputs {
namespace {

std::vector<Slices> measured(Rig& rig, const std::vector<std::string>& inputs) {
  std::vector<SerialInput> at_once;
  for (const std::string& bytes : inputs) at_once.push_back({{.pause_us = 0, .bytes = bytes}});
  return rig.measure({}, at_once, 2);
}

std::uint32_t of(const Slices& slices, units::Task task) {
  return slices[static_cast<std::size_t>(task)];
}

class RigTest : public testing::Test {
 protected:
  const sim::ElfImage firmware = sim::read_elf(tests::firmware_file);
  const machine::Description description = tests::default_machine();
  Rig rig{firmware, description, 4'000'000, 129'823};
};

TEST_F(RigTest, measures_each_input_by_itself) {
  const auto slices = measured(rig, {"G2 X120 I10 J0\n", "M82\n"});
  const std::uint32_t arc = of(slices.at(0), units::Task::commands);
  EXPECT_GT(arc, 10'000U);
  EXPECT_LT(of(slices.at(1), units::Task::commands), arc / 2) << "it did not see the one before";
}

TEST_F(RigTest, measures_what_a_second_piece_of_a_line_costs) {
  const Slices slices = rig.measure({}, {{{0, "M11"}, {5'000, "8 text\n"}}}, 1).at(0);
  EXPECT_GT(of(slices, units::Task::serial_line), 1'000U);
  EXPECT_GT(of(slices, units::Task::commands), 1'000U);
}

TEST_F(RigTest, waits_until_lines_are_done_where_the_input_says_so) {
  // M112 acts when it comes, before the lines that wait.
  SerialInput input{{.pause_us = 0, .bytes = "G4 P3\nG2 X120 I10 J0\n"},
                    {.pause_us = 0, .bytes = "M112\n", .waits = true}};
  const std::uint32_t arc = of(rig.measure({}, {input}, 1).at(0), units::Task::commands);
  EXPECT_GT(arc, 8'000U);
  input.back().waits = false;
  EXPECT_LT(of(rig.measure({}, {input}, 1).at(0), units::Task::commands), arc / 2);
}

TEST_F(RigTest, measures_calls_clock_by_clock) {
  timing::Program program = timing::read_program(tests::firmware_file);
  const timing::Address parse = program.find("gcode::parse").front();
  const timing::Address halt = program.find("Application::halt").front();
  const auto longest = [&](const std::string& bytes) {
    return rig.longest_calls({}, {{.pause_us = 0, .bytes = bytes}}, program, false, {parse, halt});
  };
  const auto shorter = longest("M82\n"), longer = longest("G1 X101.25 F1200\n");
  EXPECT_GT(shorter.at(0), 50U);
  EXPECT_GT(longer.at(0), 2 * shorter.at(0));
  EXPECT_EQ(longer.at(1), 0U) << "it was not called";
  EXPECT_GT(longest("M112\n").at(1), 0U);
}

TEST_F(RigTest, begins_each_time_with_the_same_printer) {
  const auto slices = measured(rig, {"G1 X3 F900\n", "M112\n", "G4 S1000\n", "M110 N5\nN9 M105*9\n",
                                     "M92 X1\n", "G1 X3 F900\n"});
  EXPECT_EQ(slices.front(), slices.back());
  EXPECT_NE(slices.front(), slices.at(3));
}

// What has been measured is of the input alone.
TEST_F(RigTest, measures_behind_a_start) {
  const SerialInput at_once{{.pause_us = 0, .bytes = "G2 X120 I10 J0\n"}};
  const SerialInput dwell{{.pause_us = 0, .bytes = "G4 S1000\n"}};
  const auto commands = [&](const SerialInput& start, const SerialInput& input) {
    return of(rig.measure(start, {input}, 1).at(0), units::Task::commands);
  };
  const std::uint32_t arc = commands({}, at_once);
  EXPECT_GT(arc, 10'000U);
  EXPECT_LT(commands(dwell, at_once), arc / 2) << "it waits behind the dwell";
  SerialInput done = at_once;
  done.push_back({.pause_us = 0, .bytes = {}, .waits = true});
  EXPECT_LT(commands(done, {{.pause_us = 0, .bytes = "M82\n"}}), arc / 2) << "taken over";
  EXPECT_EQ(commands({}, at_once), arc) << "a start leaves nothing behind";
}

TEST_F(RigTest, has_each_start_in_the_state_that_it_names) {
  const std::vector<SerialInput> end{{{.pause_us = 0, .bytes = "M400\n"}}};
  std::map<std::string_view, Slices> slices;
  for (const Start& start : starts()) slices[start.name] = rig.measure(start.input, end, 1).at(0);
  const auto refill = [&](std::string_view name) {
    return of(slices.at(name), units::Task::refill);
  };
  for (const char* moves :
       {"an arc", "small lines, large jerk", "small lines", "small lines, a little longer"}) {
    EXPECT_GT(refill(moves), 5 * refill("at rest")) << moves;
  }
  EXPECT_GT(of(slices.at("reports that are due"), units::Task::reports),
            5 * of(slices.at("at rest"), units::Task::reports));
}

// Which has no passes: one pass follows the other until the last line but two enters it.
TEST_F(RigTest, ends_an_input_in_the_boot_loader) {
  using namespace std::string_literals;
  const SerialInput input{
      {.pause_us = 4'221, .bytes = "\x01 "},
      {.pause_us = 0, .bytes = "\nM78\nG3 X4 R255Z0.0001\n\nM", .waits = true},
      {.pause_us = 22,
       .bytes = "M501-GGGG\n\n\n\n\n\n\n\n\n\0G\n\nGG\0"s +
                "70642865GG\n\n\n\n\n\n\n\n\n\0G\n\nGGG1"s + "\n\n\n\n\n\n\n\n\n\0G\n"s},
      {.pause_us = 0, .bytes = "\nM997(a comment) ;9.720040\nMTE5\nM410\nM", .waits = true}};
  const std::vector<Start> all = starts();
  for (const Start& start : all) {
    if (start.name != "slow lines, by junction deviation") continue;
    EXPECT_GT(of(rig.measure(start.input, {input}, 1).at(0), units::Task::commands), 0U);
    return;
  }
  ADD_FAILURE() << "no such start";
}

TEST_F(RigTest, sees_a_pass_without_an_end) {
  sim::ElfImage faulty = firmware;
  const timing::Address halt =
      timing::read_program(tests::firmware_file).find("Application::halt").front();
  constexpr std::array<std::uint8_t, 4> jump_to_itself{0x6f, 0, 0, 0};
  for (sim::ElfSegment& segment : faulty.segments) {
    if (halt < segment.address || halt - segment.address >= segment.bytes.size()) continue;
    std::ranges::copy(jump_to_itself, segment.bytes.begin() + (halt - segment.address));
  }
  Rig faulty_rig(faulty, description, 4'000'000, 150'000);
  EXPECT_NO_THROW(measured(faulty_rig, {"G1 X3 F900\n"}));
  try {
    measured(faulty_rig, {"M112\n"});
    ADD_FAILURE() << "the pass ended";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("M112\\n: a pass takes more than 150000 clocks"));
  }
}

}  // namespace
}  // namespace worst_inputs
