// SPDX-License-Identifier: Apache-2.0
// The plan of a whole example, what is written of it, and how long planning takes.
#include <gmock/gmock.h>
#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "directories.hpp"
#include "sim/devices/gcode_file.hpp"
#include "tools/planning/plan_texts.hpp"
#include "tools/planning/print_planner.hpp"

namespace planning {
namespace {

Plan plan_of_file(const char* file) {
  const auto commands = devices::read_gcode_file(file);
  PrintPlanner planner(4'000'000);
  for (const auto& command : *commands) planner.take(command.file_line, command.text);
  return planner.finish();
}

double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

TEST(plan_file, has_every_layer_of_the_washer) {
  const Plan plan = plan_of_file(PROJECT_DIRECTORY "/examples/washer.gcode");
  EXPECT_EQ(plan.fault, "");
  EXPECT_THAT(plan.refused, testing::IsEmpty());
  EXPECT_EQ(plan.underruns, 0u);
  ASSERT_FALSE(plan.layers.empty());
  EXPECT_NEAR(plan.layers.front().z_mm, 0.2, 0.001);
  for (std::size_t i = 1; i < plan.layers.size(); ++i) {
    EXPECT_NEAR(plan.layers[i].z_mm - plan.layers[i - 1].z_mm, 0.2, 0.001) << i;
  }
}

TEST(plan_file, is_written_as_json_and_as_text) {
  PrintPlanner planner(4'000'000);
  planner.take(3, "G1 X10 F600");
  planner.take(7, "M9999");
  const Plan plan = planner.finish();
  const auto json = nlohmann::json::parse(to_json(plan));
  EXPECT_NEAR(json["seconds"].get<double>(), plan.seconds, 1e-6);
  EXPECT_EQ(json["axes"]["x"]["steps_forward"], 800);
  EXPECT_EQ(json["refused"][0]["line"], 7);
  EXPECT_EQ(json["refused"][0]["text"], "M9999");
  EXPECT_THAT(to_text(plan), testing::HasSubstr("line 7 refused: M9999"));
}

TEST(plan_file, lists_no_more_refused_lines_than_asked_for_and_counts_all) {
  PrintPlanner planner(4'000'000);
  for (std::size_t line = 1; line <= 5; ++line) planner.take(line, "M9999");
  const Plan plan = planner.finish();
  for (const std::size_t most : {0u, 3u, 5u, 6u}) {
    const std::size_t listed = std::min<std::size_t>(most, 5);
    const auto json = nlohmann::json::parse(to_json(plan, {.refused = most}));
    EXPECT_EQ(json["refused"].size(), listed) << most;
    EXPECT_EQ(json["refused_lines"], 5) << most;
    const std::string text = to_text(plan, {.refused = most}),
                      last = "line " + std::to_string(listed);
    EXPECT_EQ(text.contains(last + " refused"), listed > 0) << most;
    EXPECT_FALSE(text.contains("line " + std::to_string(listed + 1) + " refused")) << most;
    const std::string more = std::to_string(5 - listed) + " more lines refused";
    EXPECT_EQ(text.contains(more), listed < 5) << most;
  }
}

TEST(plan_file, lists_no_more_layers_than_asked_for_and_counts_all) {
  PrintPlanner planner(4'000'000);
  for (std::size_t layer = 0; layer < 5; ++layer) {
    planner.take(3 * layer + 1, "G1 Z" + std::to_string(layer + 1) + " F300");
    planner.take(3 * layer + 2, "G1 X" + std::to_string(layer % 2 + 1) + " E" +
                                    std::to_string(layer + 1) + " F600");
  }
  const Plan plan = planner.finish();
  ASSERT_EQ(plan.layers.size(), 5u);
  for (const std::size_t most : {0u, 3u, 5u, 6u}) {
    const std::size_t listed = std::min<std::size_t>(most, 5);
    const auto json = nlohmann::json::parse(to_json(plan, {.layers = most}));
    EXPECT_EQ(json["layers"].size(), listed) << most;
    EXPECT_EQ(json["layer_count"], 5) << most;
    const std::string text = to_text(plan, {.layers = most});
    EXPECT_EQ(text.contains("layer at Z 4.000"), listed > 3) << most;
    EXPECT_EQ(text.contains(std::to_string(5 - listed) + " more layers"), listed < 5) << most;
  }
}

TEST(plan_file, shows_the_begin_of_a_long_refused_line) {
  PrintPlanner planner(4'000'000);
  planner.take(1, "G1 X" + std::string(100'000, '1'));
  const Plan plan = planner.finish();
  EXPECT_LT(to_text(plan).size(), 2'000u);
  EXPECT_LT(to_json(plan).size(), 4'000u);
  EXPECT_THAT(to_text(plan), testing::HasSubstr("line 1 refused: G1 X111"));
}

// Of processor time, so that other programs do not count. On a core of 3 GHz there are some times
// as many.
TEST(plan_file, takes_at_least_200_000_moves_a_second) {
  constexpr int moves = 200'000;
  PrintPlanner planner(50'000'000);
  const double begin = processor_seconds();
  for (int i = 1; i <= moves; ++i) {
    char line[64];
    std::snprintf(line, sizeof line, "G1 X%.3f Y%.3f E%.5f", 50 + 40 * std::sin(i * 0.02),
                  50 + 40 * std::cos(i * 0.02), i * 0.02);
    planner.take(static_cast<std::size_t>(i), line);
  }
  const Plan plan = planner.finish();
  const double rate = static_cast<double>(plan.moves) / (processor_seconds() - begin);
  std::printf("%.0f moves/s\n", rate);
  EXPECT_EQ(plan.moves, static_cast<std::uint64_t>(moves));
  EXPECT_THAT(plan.refused, testing::IsEmpty());
  EXPECT_GE(rate, 200'000);
}

}  // namespace
}  // namespace planning
