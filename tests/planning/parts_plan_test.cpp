// SPDX-License-Identifier: Apache-2.0
// Plans for machines with backlash, and with lengths of loading.
#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "machine/machine.hpp"
#include "tools/planning/print_planner.hpp"

namespace planning {
namespace {

constexpr motion::BacklashSettings backlash{.lengths = {units::Nanometers(200'000)}};
constexpr application::FilamentChange change{.load = units::Nanometers(30'000'000),
                                             .unload = units::Nanometers(20'000'000),
                                             .load_speed = units::MicrometersPerSecond(20'000),
                                             .unload_speed = units::MicrometersPerSecond(20'000)};

Plan plan_of(const application::MachineDescription& machine,
             const std::vector<std::string>& lines) {
  PrintPlanner planner(machine, 50'000'000);
  std::size_t number = 0;
  for (const std::string& line : lines) planner.take(++number, line);
  return planner.finish();
}

// X turns back twice after homing has pushed it to its end stop, and once from there.
TEST(parts_plan, counts_the_steps_that_motors_take_up) {
  const std::vector<std::string> lines{"G28", "G1 X50 F6000", "G1 X40 Y10", "G1 X50 Y20"};
  application::MachineDescription machine = machine::machine;
  const Plan without = plan_of(machine, lines);
  machine.backlash = &backlash;
  const Plan with = plan_of(machine, lines);
  EXPECT_THAT(with.refused, testing::IsEmpty());
  // Homing turns back once more, and ends at the end stop either way.
  EXPECT_EQ(with.axes[0].steps_forward - without.axes[0].steps_forward, 3 * 16);
  EXPECT_EQ(with.axes[1].steps_forward, without.axes[1].steps_forward);
}

TEST(parts_plan, counts_filament_that_is_loaded_and_unloaded) {
  application::MachineDescription machine = machine::machine;
  machine.filament_change = &change;
  const Plan plan = plan_of(machine, {"G28", "M701", "M702 U5"});
  EXPECT_THAT(plan.refused, testing::IsEmpty());
  EXPECT_EQ(plan.axes[3].steps_forward, 30 * 500);
  EXPECT_EQ(plan.axes[3].steps_backward, 5 * 500);
}

}  // namespace
}  // namespace planning
