// SPDX-License-Identifier: Apache-2.0
// What makes a print bad, each by itself; and how report.json says it.
#include "sim/report/verdict.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "sim/report/json_report.hpp"

namespace {

using report::Results;
using testing::HasSubstr;

Results good_results() {
  Results results;
  results.outcome = report::Outcome::completed;
  results.points_reached = 10;
  results.max_deviation_mm = 0.0125;
  results.max_deviation_steps = 1;
  results.findings.warning_count = 3;
  return results;
}

struct Fault {
  const char* words;
  std::function<void(Results&)> put_in;
};

TEST(Verdict, is_good_where_nothing_is_wrong_but_warnings) {
  Results results = good_results();
  judge(results);
  EXPECT_TRUE(results.good());
  EXPECT_EQ(nlohmann::json::parse(to_json(results))["verdict"], "good");
  results.outcome = report::Outcome::stopped;
  results.points_missed = 1;  // on the way to it
  judge(results);
  EXPECT_TRUE(results.good());
}

TEST(Verdict, is_bad_for_each_fault_by_itself) {
  const std::vector<Fault> faults{
      {"Thermal Runaway",
       [](Results& r) {
         r.outcome = report::Outcome::faulted;
         r.fault = "Error:Thermal Runaway";
       }},
      {"the print faulted", [](Results& r) { r.outcome = report::Outcome::faulted; }},
      {"27 lines that should move or heat refused",
       [](Results& r) { r.findings.refused_count = 27; }},
      {"2 of 12 points missed (E 2)",
       [](Results& r) {
         r.points_missed = 2;
         r.findings.missed_by_axis = {0, 0, 0, 2};
       }},
      {"leaves its lines by up to 0.026 mm",
       [](Results& r) {
         r.max_deviation_mm = 0.026;
         r.max_deviation_steps = 2.1;
       }},
      {"3 lines on which Z or E does not go along", [](Results& r) { r.findings.lines_apart = 3; }},
      {"Z leaves the height above the mesh by up to 0.020 mm",
       [](Results& r) { r.findings.max_height_error_mm = 0.02; }},
      {"homing ended away from the end stop: Y",
       [](Results& r) { r.findings.homed_elsewhere[1] = true; }},
      {"axes moved after the last line: Z",
       [](Results& r) { r.findings.moved_after_end[2] = true; }},
      {"the bed was 10.1 °C off its target", [](Results& r) { r.bed.band_c = 10.1; }},
      {"no line asks for: Z 4", [](Results& r) { r.axes[2].unasked_steps = 4; }},
      {"1 line of the file lost", [](Results& r) { r.findings.lines_lost = 1; }},
      {"5 underruns", [](Results& r) { r.underruns = 5; }},
      {"break the driver's times: Y 1", [](Results& r) { r.axes[1].illegal_pulses = 1; }},
      {"steps lost by the motors: X 64", [](Results& r) { r.axes[0].slipped_steps = 64; }},
      {"steps lost by the motors: X 1", [](Results& r) { r.axes[0].disabled_pulses = 1; }},
      {"steps lost by the motors: X 2", [](Results& r) { r.axes[0].frame_steps = 2; }},
  };
  for (const Fault& fault : faults) {
    Results results = good_results();
    fault.put_in(results);
    judge(results);
    EXPECT_FALSE(results.good());
    ASSERT_EQ(results.findings.problems.size(), 1U) << fault.words;
    EXPECT_THAT(results.findings.problems[0], HasSubstr(fault.words));
    EXPECT_EQ(nlohmann::json::parse(to_json(results))["verdict"], "bad");
  }
}

TEST(Verdict, is_written_with_its_lists) {
  Results results = good_results();
  results.points_missed = 1;
  results.findings.missed_by_axis = {1, 0, 0, 0};
  results.findings.lines_lost = 4;
  results.findings.refused_count = 1;
  results.findings.refused = {{7, "G2 X1", "Unknown command", true}};
  results.findings.warnings = {{8, "M900 K1", "Unknown command", false}};
  report::MissedPoint point{.file_line = 9, .text = "G1 X20", .seconds = 1.5};
  point.axes[0] = {true, 20, 1600, 1520, 19};
  results.findings.missed = {point};
  judge(results);
  const nlohmann::json json = nlohmann::json::parse(to_json(results));
  EXPECT_EQ(json["result"], "completed");
  EXPECT_EQ(json["problems"].size(), 3U);
  EXPECT_EQ(json["lines"]["refused"], 1);
  EXPECT_EQ(json["lines"]["warnings"], 3);
  EXPECT_EQ(json["lines"]["lost"], 4);
  EXPECT_EQ(json["path"]["points_missed_by_axis"]["x"], 1);
  EXPECT_EQ(json["refused_lines"][0]["file_line"], 7);
  EXPECT_EQ(json["refused_lines"][0]["reason"], "Unknown command");
  EXPECT_EQ(json["warnings"][0]["text"], "M900 K1");
  EXPECT_EQ(json["missed_points"][0]["file_line"], 9);
  EXPECT_EQ(json["missed_points"][0]["seconds"], 1.5);
  EXPECT_EQ(json["missed_points"][0]["axes"].size(), 1U);
  EXPECT_EQ(json["missed_points"][0]["axes"]["x"]["wanted_mm"], 20);
  EXPECT_EQ(json["missed_points"][0]["axes"]["x"]["reached_steps"], 1520);
}

}  // namespace
