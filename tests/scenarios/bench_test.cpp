// SPDX-License-Identifier: Apache-2.0
// The benchmarks, short: they measure what they say, and the hardware is what the design claims.
#include <gmock/gmock.h>

#include <array>
#include <fstream>
#include <map>
#include <string>
#include <utility>

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

// Besides what the clean rates are: each tick within a microsecond, by the pins.
void expect_punctual_rates(const nlohmann::json& figures) {
  EXPECT_EQ(figures["tolerance_us"], 1);
  const double tolerance_clocks = figures["clock_hz"].get<double>() / 1e6;
  const auto& clean = figures["highest_clean_rate"];
  const auto& punctual = figures["highest_punctual_rate"];
  ASSERT_EQ(punctual.size(), clean.size());
  for (const auto& [what, rates] : punctual.items()) {
    for (const std::string stepping : {"hardware", "software"}) {
      const std::string clocks = stepping + "_clocks_per_step";
      EXPECT_GE(rates[clocks], clean[what][clocks]) << what;
      EXPECT_LE(rates[stepping + "_largest_lateness_clocks"], tolerance_clocks) << what;
    }
    // Its ticks come in the first clock at or after their instant.
    EXPECT_LE(rates["hardware_largest_lateness_clocks"], 1.01) << what;
    const double ratio = rates["software_clocks_per_step"].get<double>() /
                         rates["hardware_clocks_per_step"].get<double>();
    EXPECT_NEAR(figures["punctual_ratio"][what].get<double>(), ratio, 1e-5) << what;
  }
  const std::string lines = "bare_loop_1_axis_guard_1_lines_of_500_ticks";
  EXPECT_EQ(punctual[lines]["hardware_clocks_per_step"], 2);
}

TEST(bench, stepping_measures_hardware_and_software) {
  const auto figures = quick_figures();
  for (const auto& row : figures["hardware"]["jitter"]) {
    const double asked = row["asked_clocks"];
    const bool divides = asked == static_cast<int>(asked);
    EXPECT_LE(row["max_clocks"].get<int>() - row["min_clocks"].get<int>(), divides ? 0 : 1) << row;
    EXPECT_NEAR(row["mean_clocks"], asked, 0.001);
  }
  for (const auto& train : figures["hardware"]["train_10_khz"]) EXPECT_EQ(train["hertz"], 10'000);
  for (const auto& train : figures["software"]["train_10_khz"]) {
    EXPECT_NEAR(train["hertz"], 10'000, 0.5);
    // Masked interrupts and a bus access, but not more.
    EXPECT_LE(train["max_clocks"].get<int>() - train["min_clocks"].get<int>(), 200);
  }
  const auto& rates = figures["highest_clean_rate"];
  const auto hardware_runs_at_every_second_clock = [&rates](const std::string& what) {
    EXPECT_EQ(rates[what]["hardware_clocks_per_step"], 2) << what;
    EXPECT_EQ(rates[what]["hardware_steps_per_second_per_axis"], 25'000'000) << what;
  };
  const auto software_needs = [&](const std::string& what, int least, int most) {
    EXPECT_GT(rates[what]["software_clocks_per_step"], least) << what;
    EXPECT_LT(rates[what]["software_clocks_per_step"], most) << what;
    const double ratio = rates[what]["software_clocks_per_step"].get<double>() /
                         rates[what]["hardware_clocks_per_step"].get<double>();
    EXPECT_NEAR(figures["ratio"][what].get<double>(), ratio, 1e-5) << what;
  };
  for (const std::string loop : {"bare_loop_1_axis_guard_1", "bare_loop_4_axes_guard_1"}) {
    hardware_runs_at_every_second_clock(loop + "_lines_of_500_ticks");
    hardware_runs_at_every_second_clock(loop + "_one_line");
    software_needs(loop + "_lines_of_500_ticks", 30, 80);
    software_needs(loop + "_one_line", 25, 70);
  }
  // Under the guards of real drivers both come to what those permit, or near it.
  constexpr std::array<std::pair<const char*, int>, 3> drivers{
      {{"A4988", 100}, {"DRV8825", 190}, {"TMC2209", 12}}};
  for (const auto& [driver, least] : drivers) {
    const std::string what = std::string("bare_loop_4_axes_") + driver + "_lines_of_500_ticks";
    EXPECT_EQ(rates[what]["hardware_clocks_per_step"], least) << what;
    software_needs(what, least, least + 70);
  }
  // A print is planned as well: that costs either way, and most where each line is short.
  hardware_runs_at_every_second_clock("whole_firmware_1_axis_guard_1_one_line");
  software_needs("whole_firmware_1_axis_guard_1_one_line", 60, 200);
  software_needs("whole_firmware_1_axis_guard_1_lines_of_500_ticks", 60, 250);
  const auto& lines = rates["whole_firmware_1_axis_guard_1_lines_of_500_ticks"];
  EXPECT_GT(lines["hardware_clocks_per_step"], 2);
  EXPECT_LT(lines["hardware_clocks_per_step"], 200);
  EXPECT_EQ(lines["hardware_limited_by"], "rate not reached");
  EXPECT_FALSE(figures["published"].empty());
  for (const auto& published : figures["published"]) {
    EXPECT_TRUE(published["source"].get<std::string>().starts_with("https://")) << published;
  }
  expect_punctual_rates(figures);
}

// What the processor is asked to be: clocks per instruction on the firmware's own code.
TEST(bench, processor_measures_works_and_finds_where_the_clocks_go) {
  const auto folder = scenarios::scratch_folder();
  const auto file = folder / "processor.json";
  std::filesystem::remove(file);
  const auto job = scenarios::run_job(
      {"bench", "processor", "--quick", "--json", file.string(), "--report", folder.string()});
  ASSERT_EQ(job.status, 0) << job.output;
  EXPECT_TRUE(std::filesystem::exists(folder / "processor.html"));
  std::ifstream stream(file);
  const auto figures = nlohmann::json::parse(stream);
  EXPECT_EQ(figures["works"].size(), 6u);
  for (const auto& work : figures["works"]) {
    const auto& compiled = work["rv32imc"];
    EXPECT_LE(compiled["clocks_per_instruction"], 1.36) << work["name"];
    EXPECT_GT(compiled["clocks_per_instruction"], 1.0) << work["name"];
    EXPECT_LT(compiled["code_bytes"], work["rv32im"]["code_bytes"]) << work["name"];
    std::uint64_t waited = 0;
    for (const auto& clocks : work["waiting_clocks"]) waited += clocks.get<std::uint64_t>();
    EXPECT_EQ(compiled["instructions"].get<std::uint64_t>() + waited, compiled["clocks"]);
    EXPECT_EQ(work["waiting_clocks"]["other"], 0) << work["name"];
  }
  EXPECT_LT(figures["firmware"]["rv32imc_code_bytes"].get<double>(),
            0.85 * figures["firmware"]["rv32im_code_bytes"].get<double>());
}

TEST(bench, link_measures_lines_and_their_answers) {
  const auto folder = scenarios::scratch_folder();
  const auto file = folder / "link.json";
  std::filesystem::remove(file);
  const auto job = scenarios::run_job({"bench", "link", "--quick", "--json", file.string()});
  ASSERT_EQ(job.status, 0) << job.output;
  std::ifstream stream(file);
  const auto figures = nlohmann::json::parse(stream);
  // 3 Mbaud need more than 4 MHz.
  EXPECT_EQ(figures["lines_of_27_characters"].size(), 4u * 3 + 4 * 2);
  EXPECT_EQ(figures["lines_of_8_characters"].size(), 5u);
  EXPECT_EQ(figures["arc_of_1200_segments"].size(), 5u);
  for (const auto& series : {"lines_of_27_characters", "lines_of_8_characters"}) {
    for (const auto& row : figures[series]) {
      EXPECT_GT(row["lines_per_second"], 0) << row;
      // A window's last lines may have come before the first answer that counts.
      const double room = row["window"] == 1 ? 1.0 : 1.2;
      EXPECT_LT(row["lines_per_second"], room * row["line_limit_per_second"].get<double>()) << row;
      if (row["window"] != 1) continue;
      EXPECT_GT(row["mean_latency_us"], 0) << row;
      EXPECT_GE(row["longest_latency_us"], row["mean_latency_us"]) << row;
    }
  }
  // A line is answered when its end has come, not when a timer expires.
  for (const auto& row : figures["lines_of_8_characters"]) {
    if (row["clock_hz"] == 4'000'000) continue;
    EXPECT_LT(row["longest_latency_us"], 500) << row;
  }
  for (const auto& row : figures["arc_of_1200_segments"]) {
    EXPECT_GT(row["motion_seconds"], 0) << row;
  }
  EXPECT_EQ(figures["behind_a_waiting_move"].size(), 4u);
  for (const auto& row : figures["behind_a_waiting_move"]) {
    EXPECT_GT(row["mean_answer_us"], 0) << row;
    EXPECT_GT(row["mean_stop_us"], 0) << row;
    if (row["clock_hz"] == 4'000'000) continue;
    // Neither a number nor what waits delays a stop.
    EXPECT_LT(row["longest_stop_us"], 1'000) << row;
  }
}

TEST(bench, model_reports_how_fast_it_runs_and_what_leaps_and_resting_blocks_bring) {
  const auto folder = scenarios::scratch_folder();
  const auto file = folder / "model.json";
  std::filesystem::remove(file);
  const auto job = scenarios::run_job({"bench", "model", "--quick", "--json", file.string()});
  ASSERT_EQ(job.status, 0) << job.output;
  std::ifstream stream(file);
  const auto works = nlohmann::json::parse(stream)["works"];
  ASSERT_EQ(works.size(), 6u);
  for (const auto& work : works) {
    EXPECT_GT(work["clocks_per_second"], 0) << work;
    EXPECT_NEAR(work["simulated_seconds_per_second"],
                work["clocks_per_second"].get<double>() / work["clock_hz"].get<double>(), 1e-6);
    EXPECT_GT(work["clocks_per_second_processor_by_netlist"], 0) << work;
    EXPECT_GT(work["clocks_per_second_without_leaps"], 0) << work;
    EXPECT_EQ(work["clocks_per_second_all_edges"] > 0, work["clock_hz"] == 4'000'000) << work;
  }
  EXPECT_LT(works[0]["awake"], 0.5);
  EXPECT_GT(works[1]["awake"].get<double>(), works[0]["awake"].get<double>());
  EXPECT_LT(works[2]["awake"].get<double>(), works[1]["awake"].get<double>());
  EXPECT_GT(works[3]["awake"].get<double>(), works[0]["awake"].get<double>());
  EXPECT_EQ(works[4]["awake"], 1);
  EXPECT_GT(works[4]["instructions_per_clock"], 0.7);
  // On any machine, however busy: what the processor's model is for.
  EXPECT_GT(works[4]["clocks_per_second"].get<double>(),
            5 * works[4]["clocks_per_second_processor_by_netlist"].get<double>());
}

// Shares are measured, some with few samples. What must be in them is known, but not how much.
TEST(bench, model_says_where_the_time_goes) {
  const auto folder = scenarios::scratch_folder();
  const auto file = folder / "profile.json";
  std::filesystem::remove(file);
  const auto job = scenarios::run_job({"bench", "model", "--profile", "--json", file.string()});
  ASSERT_EQ(job.status, 0) << job.output;
  std::ifstream stream(file);
  std::map<std::string, nlohmann::json> works;
  const auto figures = nlohmann::json::parse(stream);
  for (const auto& work : figures["works"]) works[work["name"]] = work;
  ASSERT_EQ(works.size(), 6u);
  for (const auto& [name, work] : works) {
    double shares = 0;
    for (const auto& share : work["shares"]) shares += share.get<double>();
    EXPECT_NEAR(shares, 1, 1e-9) << name;
    // One in each tick of the kernel, which are at most 10 ms apart; a busy machine may lose some.
    EXPECT_GT(work["samples"], 10 * work["simulation_thread_seconds"].get<double>()) << name;
    EXPECT_LE(work["simulation_thread_seconds"], work["processor_seconds"].get<double>() + 0.1);
    EXPECT_EQ(work["leapt_clocks"].get<long>() + work["evaluated_clocks"].get<long>(),
              work["clocks"])
        << name;
    long ends = 0, evaluated = 0;
    for (const auto& count : work["leaps_ended_by"]) ends += count.get<long>();
    for (const auto& count : work["evaluated_for"]) evaluated += count.get<long>();
    EXPECT_EQ(ends, work["leaps"]) << name;
    EXPECT_GE(evaluated, work["evaluated_clocks"]) << name;
  }
  // A program without end has no devices, and a sleeping one no steps.
  EXPECT_GT(works["computing"]["shares"]["processor_model"], 0);
  EXPECT_EQ(works["computing"]["evaluated_for"]["after_input"], 0);
  EXPECT_EQ(works["asleep"]["leaps_ended_by"]["time_base"], 0);
  EXPECT_GT(works["asleep"]["leapt_clocks"].get<long>(), works["asleep"]["evaluated_clocks"]);
  EXPECT_GT(works["asleep"]["leaps_ended_by"]["converter"], 0);
  for (const char* name : {"printing", "printing at 50 MHz", "serving"}) {
    const auto& work = works[name];
    EXPECT_GT(work["leaps_ended_by"]["time_base"], 1000) << work;
    EXPECT_GT(work["evaluated_for"]["axes"], 1000) << work;
    EXPECT_GT(work["shares"]["netlist"], 0) << work;
  }
  EXPECT_GT(works["printing"]["shares"]["processor_model"], 0);
  EXPECT_GT(works["serving"]["shares"]["host_and_report"], 0);
  EXPECT_EQ(scenarios::run_job({"bench", "link", "--profile", "--quick"}).status, 2);
}

}  // namespace
