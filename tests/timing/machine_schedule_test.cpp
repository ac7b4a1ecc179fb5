// SPDX-License-Identifier: Apache-2.0
// Which machines are refused, and what is left out of the check of others.
#include "tools/timing/machine_schedule.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace timing {
namespace {

using application::MachineDescription;
using testing::HasSubstr;
using testing::IsEmpty;
using units::Task;

const Clocks planning_allowance = Facts().allowances[static_cast<std::size_t>(Task::planning)];
constexpr Rate slow{4'000'000, 250'000}, fast{50'000'000, 250'000};

// All that has a bound has this one, but for the tasks.
Schedule schedule_with(Clocks of_all, Clocks of_planning) {
  Schedule schedule{.facts = {}, .load = {}, .rows = {}, .problems = {}};
  Load& load = schedule.load;
  load.tasks.fill(of_all);
  load.gaps.fill(100);
  load.tasks[static_cast<std::size_t>(Task::planning)] = of_planning;
  load.pass = of_all * (units::task_count - 1) + of_planning;
  load.start = 100;
  load.line = of_all / 2;
  load.refill_without_line = of_all / 4;
  return schedule;
}

MachineDescription plain() {
  MachineDescription machine;
  machine.baud = slow.baud;
  return machine;
}

MachineDescription levelled() {
  static const motion::LevellingSettings settings{};
  MachineDescription machine = plain();
  machine.levelling = &settings;
  return machine;
}

MachineDescription delta() {
  MachineDescription machine = plain();
  machine.kinematics = motion::kinematics::Delta::Parameters{};
  return machine;
}

MachineDescription shaped() {
  MachineDescription machine = plain();
  machine.shaping = motion::ShapingSettings{};
  return machine;
}

TEST(MachineSchedule, is_whole_for_a_machine_without_such_parts) {
  EXPECT_THAT(left_out({}).requirements, IsEmpty());
  EXPECT_EQ(refusal_of(schedule_with(8'000, 8'000), {}, slow), "");
  const std::string refusal = refusal_of(schedule_with(8'000, 90'000), {}, fast);
  EXPECT_THAT(refusal, HasSubstr(fmt::format("allowance: 90000 of {} clocks", planning_allowance)));
  EXPECT_THAT(refusal, HasSubstr("no clock helps"));
}

TEST(MachineSchedule, of_core_xy_has_a_longer_least_line) {
  MachineDescription machine;
  machine.kinematics = motion::kinematics::CoreXy::Parameters{};
  ASSERT_TRUE(machine.is_heavy());
  EXPECT_FALSE(delta().is_heavy());
  EXPECT_THAT(left_out(machine).requirements, IsEmpty());
  Schedule schedule = schedule_with(8'000, planning_allowance + 1'000);
  EXPECT_NE(refusal_of(schedule, machine, fast), "");
  schedule.facts = application::schedule_facts(false, machine.is_heavy());
  EXPECT_EQ(refusal_of(schedule, machine, fast), "");
}

TEST(MachineSchedule, of_long_plans_leaves_out_that_motion_goes_on) {
  for (const MachineDescription& machine : {levelled(), delta()}) {
    EXPECT_EQ(left_out(machine).requirements.size(), 2U);
    EXPECT_EQ(refusal_of(schedule_with(8'000, 90'000), machine, fast), "");
    const std::string refusal = refusal_of(schedule_with(8'000, 2'000'000), machine, slow);
    EXPECT_THAT(refusal, HasSubstr("M112 stops"));
    EXPECT_THAT(refusal, HasSubstr("a faster clock"));
  }
}

TEST(MachineSchedule, of_shaped_motion_and_s_curves_is_left_out) {
  MachineDescription s_curve;
  s_curve.limits.s_curve = true;
  EXPECT_EQ(left_out(s_curve).requirements.size(), requirement_count - 1);
  EXPECT_EQ(left_out(shaped()).requirements.size(), requirement_count - 1);
  EXPECT_EQ(refusal_of(schedule_with(8'000, 2'000'000), shaped(), slow), "");
  EXPECT_THAT(refusal_of(schedule_with(8'000, 10'000), shaped(), {4'000'000, 3'000'000}),
              HasSubstr("a bit of the serial line"));
}

// Without a task's bound.
Schedule schedule_without_planning() {
  Schedule schedule = schedule_with(8'000, 8'000);
  schedule.load.tasks[static_cast<std::size_t>(Task::planning)].reset();
  schedule.rows = {{.name = "the pass", .bound = 8'000, .budget = 0, .measured = {}}};
  for (const application::TaskRow& task : application::task_table) {
    schedule.rows.push_back({.name = std::string(task.name),
                             .bound = task.task == Task::planning ? std::optional<Clocks>() : 8'000,
                             .budget = 0,
                             .measured = {}});
  }
  schedule.problems = {{.place = "a.cpp:7",
                        .function = "plan",
                        .what = "a loop has no bound",
                        .remedy = "declare one"}};
  return schedule;
}

TEST(MachineSchedule, refuses_what_has_no_bound_with_place_and_remedy) {
  for (const std::optional<std::uint32_t> clock_hz : {std::optional(fast.clock_hz), {}}) {
    for (const MachineDescription& machine : {plain(), levelled(), delta()}) {
      const Verdict verdict = verdict_on(schedule_without_planning(), machine, clock_hz, "m.toml");
      EXPECT_TRUE(verdict.is_refused);
      EXPECT_EQ(verdict.text,
                "m.toml: not schedulable:\n"
                "  \"planning: stops, chords, homing\" has no bound\n"
                "a.cpp:7: in plan: a loop has no bound: declare one\n");
    }
  }
}

TEST(MachineSchedule, says_what_has_no_bound_where_that_is_left_out) {
  MachineDescription for_speed = plain();
  for_speed.fast = true;
  for (const MachineDescription& machine : {for_speed, shaped()}) {
    const Verdict verdict = verdict_on(schedule_without_planning(), machine, {}, "m.toml");
    EXPECT_FALSE(verdict.is_refused);
    EXPECT_THAT(verdict.text, HasSubstr("not checked: \"planning: stops, chords, homing\" has"));
    EXPECT_THAT(verdict.text, HasSubstr("not checked: any deadline: " + left_out(machine).reason));
  }
}

TEST(MachineSchedule, is_checked_at_the_clock_or_at_any) {
  const Schedule good = schedule_with(8'000, 8'000), bad = schedule_with(8'000, 90'000);
  EXPECT_EQ(verdict_on(good, plain(), fast.clock_hz, "m").text,
            "m: schedulable at 50000000 Hz and 250000 baud\n");
  EXPECT_THAT(verdict_on(good, plain(), {}, "m").text, HasSubstr("m: schedulable at "));
  EXPECT_FALSE(verdict_on(good, plain(), {}, "m").is_refused);
  for (const std::optional<std::uint32_t> clock_hz : {std::optional(fast.clock_hz), {}}) {
    const Verdict verdict = verdict_on(bad, plain(), clock_hz, "m");
    EXPECT_TRUE(verdict.is_refused);
    EXPECT_THAT(verdict.text, HasSubstr("m: not schedulable at "));
    EXPECT_THAT(verdict.text, HasSubstr("a shorter pass"));
  }
  // What no clock of the table helps is refused of the others too.
  const Schedule hopeless = schedule_with(8'000'000, 8'000);
  const Verdict verdict = verdict_on(hopeless, delta(), {}, "m");
  EXPECT_TRUE(verdict.is_refused);
  EXPECT_THAT(verdict.text, HasSubstr("M112 stops"));
}

}  // namespace
}  // namespace timing
