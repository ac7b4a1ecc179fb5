// SPDX-License-Identifier: Apache-2.0
// What the schedule's report says and refuses, of tasks with and without a bound; numbers that
// stand in the chip's sources as well.
#include "tools/timing/schedule_report.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "directories.hpp"

namespace timing {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Schedule schedule_with(std::optional<Clocks> pass, std::optional<Clocks> each) {
  Schedule schedule{.facts = {},
                    .load = {.pass = pass,
                             .tasks = {},
                             .start = 10,
                             .gaps = {},
                             .line = 1'000,
                             .refill_without_line = 100},
                    .rows = {},
                    .problems = {}};
  schedule.load.tasks.fill(each);
  schedule.load.gaps.fill(10);
  schedule.rows.push_back({.name = "the pass", .bound = pass, .budget = 0, .measured = {}});
  for (const application::TaskRow& task : application::task_table) {
    schedule.rows.push_back(
        {.name = std::string(task.name), .bound = each, .budget = task.budget, .measured = {}});
  }
  return schedule;
}

TEST(ScheduleReport, names_each_task_without_a_bound) {
  Schedule schedule = schedule_with({}, 100);
  schedule.rows[1].bound.reset();
  EXPECT_THAT(missing_bounds(schedule),
              ElementsAre("\"the pass\" has no bound", "\"motion: sign of life\" has no bound"));
  EXPECT_FALSE(is_schedulable(schedule));
  EXPECT_THAT(to_text(schedule),
              HasSubstr("not schedulable: \"motion: sign of life\" has no bound"));
  EXPECT_FALSE(is_schedulable(schedule_with({}, {})));
}

std::vector<std::string> texts_of_misses(const Schedule& schedule, Rate rate) {
  std::vector<std::string> texts;
  for (const Response& response : misses(schedule, rate)) texts.push_back(response.text());
  return texts;
}

TEST(ScheduleReport, refuses_what_the_tasks_with_a_bound_miss_alone) {
  // 25 ms a task at 4 MHz.
  EXPECT_THAT(texts_of_misses(schedule_with({}, 100'000), {4'000'000, 250'000}),
              testing::Contains(HasSubstr("sign of life")));
  EXPECT_THAT(texts_of_misses(schedule_with({}, 1'000), {4'000'000, 250'000}), IsEmpty());
  EXPECT_THAT(texts_of_misses(schedule_with({}, {}), {4'000'000, 3'000'000}),
              ElementsAre(HasSubstr("a bit of the serial line takes 4 clocks: 133 where")));
}

TEST(ScheduleReport, has_the_lowest_clock_of_each_offered_rate) {
  const Schedule schedule = schedule_with(20'000, 2'000);
  EXPECT_TRUE(is_schedulable(schedule));
  const auto json = nlohmann::json::parse(to_json(schedule));
  ASSERT_EQ(json["clocks"].size(), offered_baud_rates().size());
  for (const auto& clock : json["clocks"]) {
    const Rate lowest{clock["lowest_hz"], clock["baud"]};
    EXPECT_THAT(texts_of_misses(schedule, lowest), IsEmpty());
    EXPECT_THAT(texts_of_misses(schedule, {lowest.clock_hz - 1, lowest.baud}),
                testing::Not(IsEmpty()));
    EXPECT_THAT(to_text(schedule), HasSubstr("lowest clock " + clock["lowest_hz"].dump() + " Hz"));
  }
  EXPECT_EQ(json["responses"].size(),
            offered_baud_rates().size() * std::size(table_clocks_hz) * requirement_count);
}

TEST(ScheduleReport, has_a_requirement_of_each_task_with_a_deadline) {
  std::set<units::Task> required;
  for (std::size_t i = 0; i < requirement_count; ++i) {
    required.insert(row_of(static_cast<Requirement>(i)).task);
  }
  required.insert(units::Task::rest);  // the second key of the heaters' watchdog
  for (const application::TaskRow& task : application::task_table) {
    if (task.reason.empty()) continue;
    EXPECT_TRUE(required.contains(task.task)) << task.name;
  }
}

// Of a VHDL source, what the only group of the expression matches.
std::uint64_t number_in(const std::string& file, const std::string& expression) {
  std::ostringstream text;
  text << std::ifstream(std::string(PROJECT_DIRECTORY "/") + file).rdbuf();
  std::smatch match;
  const std::string whole = text.str();
  if (!std::regex_search(whole, match, std::regex(expression))) return 0;
  return std::stoull(match[1]);
}

TEST(ScheduleReport, says_why_there_is_no_clock) {
  constexpr auto slower = Requirement::heater_watchdog, faster = Requirement::horizon;
  const std::string low = row_of(slower).name, high = row_of(faster).name;
  const auto text = [&](std::uint32_t lowest, std::uint32_t highest, bool both = true) {
    ClockRange range{.lowest_hz = lowest, .highest_hz = highest};
    if (both || lowest != slowest_clock_hz) range.slower_fails = slower;
    if (both || highest != fastest_clock_hz) range.faster_fails = faster;
    return to_text(range);
  };
  constexpr std::uint32_t one = 8'000'000, other = 9'000'000;
  EXPECT_EQ(text(slowest_clock_hz, fastest_clock_hz, false), "lowest clock 100000 Hz");
  EXPECT_EQ(text(one, other),
            "lowest clock 8000000 Hz (" + low + "), highest 9000000 Hz (" + high + ")");
  EXPECT_EQ(text(other, one),
            "no clock: " + low + " needs 9000000 Hz at least, " + high + " 8000000 Hz at most");
  for (const bool both : {false, true}) {
    EXPECT_EQ(text(fastest_clock_hz + 1, fastest_clock_hz, both), "no clock: " + low + " at none");
    EXPECT_EQ(text(slowest_clock_hz, slowest_clock_hz - 1, both), "no clock: " + high + " at none");
  }
  EXPECT_EQ(text(one, slowest_clock_hz - 1), "no clock: " + high + " at none");
  EXPECT_EQ(text(fastest_clock_hz + 1, one), "no clock: " + low + " at none");
}

// Its numbers are figures, but its names and deadlines are text.
TEST(ScheduleReport, the_table_of_the_first_page_has_each_task) {
  std::ostringstream text;
  text << std::ifstream(PROJECT_DIRECTORY "/tools/figures/tables/readme_tasks.md").rdbuf();
  for (const application::TaskRow& task : application::task_table) {
    EXPECT_THAT(text.str(), HasSubstr("| " + std::string(task.name) + " | ")) << task.name;
  }
}

TEST(ScheduleFacts, are_those_of_the_chip) {
  const Facts facts;
  EXPECT_EQ(facts.early_part,
            1U << number_in("rtl/thermal/feed_watchdog.vhd", "window_shift : natural := ([0-9]+)"));
  EXPECT_EQ(facts.receive_depth,
            number_in("rtl/serial/receive_queue.vhd", "depth : positive := ([0-9]+)"));
  // Whole lines of three segments, behind two of one that has begun.
  const auto depth = number_in("rtl/printer_core.vhd", "queue_depth : positive := ([0-9]+)");
  EXPECT_EQ(facts.lines_of_a_pass, (depth - 2) / 3);
}

}  // namespace
}  // namespace timing
