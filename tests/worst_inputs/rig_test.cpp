// SPDX-License-Identifier: Apache-2.0
// The chip with its firmware measures what an input costs.
#include "tools/worst_inputs/rig.hpp"

#include <gtest/gtest.h>

#include "tests/default_machine.hpp"
#include "tests/loaded_printer.hpp"

namespace worst_inputs {
namespace {

std::uint32_t of(const Slices& slices, units::Task task) {
  return slices[static_cast<std::size_t>(task)];
}

class RigTest : public testing::Test {
 protected:
  const sim::ElfImage firmware = sim::read_elf(tests::firmware_file);
  const machine::Description description = tests::default_machine();
  Rig rig{firmware, description, 4'000'000};
};

TEST_F(RigTest, measures_each_input_by_itself) {
  const std::uint32_t arc = of(rig.measure({{0, "G2 X20 I10 J0.123\n"}}), units::Task::commands);
  const std::uint32_t query = of(rig.measure({{0, "M82\n"}}), units::Task::commands);
  EXPECT_GT(arc, 10'000U);
  EXPECT_LT(query, arc / 2) << "what came before is forgotten";
  EXPECT_EQ(rig.resets(), 0U);
}

TEST_F(RigTest, measures_what_a_second_piece_of_a_line_costs) {
  const Slices slices = rig.measure({{0, "M11"}, {5'000, "8 text\n"}});
  EXPECT_GT(of(slices, units::Task::serial_line), 1'000U);
  EXPECT_GT(of(slices, units::Task::commands), 1'000U);
}

TEST_F(RigTest, resets_a_printer_that_has_halted_or_waits) {
  rig.measure({{0, "M112\n"}});
  EXPECT_EQ(rig.resets(), 1U);
  rig.measure({{0, "G4 S1000\n"}});
  EXPECT_EQ(rig.resets(), 2U);
  EXPECT_GT(of(rig.measure({{0, "M118 a\n"}}), units::Task::commands), 1'000U);
}

}  // namespace
}  // namespace worst_inputs
