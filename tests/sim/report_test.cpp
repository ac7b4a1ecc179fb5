// SPDX-License-Identifier: Apache-2.0
// The report's formats are contracts: names of report.json, columns of the edges.
#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "directories.hpp"
#include "sim/report/edge_file.hpp"
#include "sim/report/json_report.hpp"
#include "tools/files/file_text.hpp"

namespace {

namespace fs = std::filesystem;

report::Results some_results() {
  report::Results results;
  results.file = "part <1>.gcode";
  results.machine = "Prusa Mendel";
  results.outcome = report::Outcome::faulted;
  results.fault = "Error:Thermal Runaway";
  results.clock_hz = 4'000'000;
  results.axes[1].final_position_steps = -3;
  results.hotend = {205, 206.5, 93.25, 0.5};
  results.bed = {0, 22, -1, 0};
  results.messages = {{1.5, 7, "echo:Unknown command: \"M999\"", false}};
  return results;
}

void collect_names(const nlohmann::json& json, const std::string& prefix,
                   std::set<std::string>& names) {
  for (const auto& [key, value] : json.items()) {
    if (value.is_object()) {
      collect_names(value, prefix + key + ".", names);
    } else {
      names.insert(prefix + key);
    }
  }
}

TEST(JsonReport, has_every_name_of_the_contract) {
  const nlohmann::json json = nlohmann::json::parse(report::to_json(some_results()));
  std::set<std::string> names;
  collect_names(json, "", names);
  std::vector<std::string> contract{"result",
                                    "fault",
                                    "clock_hz",
                                    "cycles",
                                    "simulated_seconds",
                                    "wall_seconds",
                                    "lines_sent",
                                    "resends",
                                    "commands_executed",
                                    "path.max_deviation_mm",
                                    "path.length_mm",
                                    "queue.underruns",
                                    "queue.guard_stalls_cycles",
                                    "queue.max_depth",
                                    "firmware.text_bytes",
                                    "firmware.data_bytes",
                                    "firmware.bss_bytes",
                                    "firmware.stack_peak_bytes",
                                    "processor.busy_percent",
                                    "processor.instructions"};
  for (const char* axis : {"x", "y", "z", "e"}) {
    for (const char* name : {"steps_forward", "steps_backward", "final_position_steps",
                             "final_position_mm", "max_step_rate_hz", "illegal_pulses"}) {
      contract.push_back(std::string("axes.") + axis + "." + name);
    }
  }
  for (const char* heater : {"hotend", "bed"}) {
    for (const char* name : {"target_c", "max_c", "seconds_to_target", "band_c"}) {
      contract.push_back(std::string(heater) + "." + name);
    }
  }
  for (const std::string& name : contract) EXPECT_TRUE(names.contains(name)) << name;
}

TEST(JsonReport, has_every_name_on_its_page) {
  const nlohmann::json json = nlohmann::json::parse(report::to_json(some_results()));
  const std::string page = files::text_of(PROJECT_DIRECTORY "/sim/report/report_json.md");
  std::set<std::string> names;
  collect_names(json, "", names);
  for (const std::string& name : names) {
    const std::string last = "`" + name.substr(name.rfind('.') + 1) + "`";
    EXPECT_NE(page.find(last), std::string::npos) << name;
  }
}

TEST(JsonReport, reports_values_as_they_are) {
  const nlohmann::json json = nlohmann::json::parse(report::to_json(some_results()));
  EXPECT_EQ(json["result"], "faulted");
  EXPECT_EQ(json["fault"], "Error:Thermal Runaway");
  EXPECT_EQ(json["axes"]["y"]["final_position_steps"], -3);
  EXPECT_EQ(json["hotend"]["seconds_to_target"], 93.25);
  EXPECT_TRUE(json["bed"]["seconds_to_target"].is_null());
  EXPECT_EQ(json["messages"][0]["file_line"], 7);
}

TEST(EdgeFile, has_the_columns_of_the_contract) {
  const fs::path file = fs::path(testing::TempDir()) / "edges_test.csv";
  report::EdgeFile edges(file);
  edges.stepped({12, 0, 1, 101});
  edges.stepped({12, 3, -1, -7});
  edges.stepped({13, 4, 1, 1});  // a second extruder
  edges.stepped({14, 5, 1, 1});  // none has a name
  edges.close();
  EXPECT_EQ(files::text_of(file),
            "cycle,axis,direction,position\n12,x,1,101\n12,e,-1,-7\n13,e1,1,1\n");
  fs::remove(file);
}

TEST(EdgeFile, says_where_it_cannot_write) {
  EXPECT_THROW(report::EdgeFile("no/such/folder/edges.csv"), std::runtime_error);
}

TEST(MessageLog, puts_a_message_to_the_line_that_is_worked_on) {
  report::MessageLog log(sim::ClockRate(4'000'000));
  log.command_sent(0, 7, "G2 X1");
  log.command_sent(0, 8, "G1 X1");
  log.reply(0, "echo:Unknown command: \"G2 X1\"");
  log.command_acknowledged(0, 7, "G2 X1", false);
  log.reply(0, "echo:something");
  log.command_acknowledged(0, 8, "G1 X1", true);
  log.reply(0, "echo:by itself");
  ASSERT_EQ(log.messages().size(), 3U);
  EXPECT_EQ(log.messages()[0].file_line, 7U);
  EXPECT_EQ(log.messages()[1].file_line, 8U);
  EXPECT_EQ(log.messages()[2].file_line, 0U);
}

}  // namespace
