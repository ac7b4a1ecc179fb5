// SPDX-License-Identifier: Apache-2.0
// The stepping benchmark, short: it measures what it says, and hardware is what the design claims.
#include <gmock/gmock.h>

#include <fstream>

#include "tests/scenarios/job.hpp"

namespace {

nlohmann::json quick_figures() {
  const auto folder = scenarios::scratch_folder();
  const auto file = folder / "stepping.json";
  std::filesystem::remove(file);
  const auto job = scenarios::run_job(
      {"bench", "stepping", "--quick", "--json", file.string(), "--report", folder.string()});
  EXPECT_EQ(job.status, 0) << job.output;
  EXPECT_TRUE(std::filesystem::exists(folder / "stepping.svg"));
  EXPECT_TRUE(std::filesystem::exists(folder / "stepping.html"));
  std::ifstream stream(file);
  return nlohmann::json::parse(stream);
}

TEST(bench, stepping_measures_hardware_and_software) {
  const auto figures = quick_figures();
  for (const auto& clean : figures["hardware"]["clean"]) {
    EXPECT_EQ(clean["clocks_per_step"], 2);
    EXPECT_EQ(clean["clocks_per_step_within_a_line"], 2);
    EXPECT_EQ(clean["steps_per_second_per_axis"], 25'000'000);
  }
  for (const auto& row : figures["hardware"]["jitter"]) {
    const double asked = row["asked_clocks"];
    const bool divides = asked == static_cast<int>(asked);
    EXPECT_LE(row["max_clocks"].get<int>() - row["min_clocks"].get<int>(), divides ? 0 : 1) << row;
    EXPECT_NEAR(row["mean_clocks"], asked, 0.001);
  }
  for (const auto& train : figures["hardware"]["train_10_khz"]) EXPECT_EQ(train["hertz"], 10'000);
  for (const auto& train : figures["software"]["train_10_khz"]) {
    EXPECT_NEAR(train["hertz"], 10'000, 0.5);
    // Interrupts kept out, and what is on the bus: not more than that.
    EXPECT_LE(train["max_clocks"].get<int>() - train["min_clocks"].get<int>(), 200);
  }
  for (const auto& clean : figures["software"]["clean"]) {
    EXPECT_GT(clean["clocks_per_step_within_a_line"], 80);
    EXPECT_LT(clean["clocks_per_step_within_a_line"], 250);
    EXPECT_LT(clean["clocks_per_step"], 500);
  }
  for (const auto& ratio : figures["ratio"]) EXPECT_GT(ratio["lines"], 100);
  EXPECT_GE(figures["published"].size(), 5u);
}

}  // namespace
