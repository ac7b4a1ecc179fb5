// SPDX-License-Identifier: Apache-2.0
// Starts the `stepfabric` program of this build and collects what it leaves.
#include "tests/scenarios/job.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <regex>

#include "directories.hpp"
#include "tools/files/write_text.hpp"
#include "tools/process/process.hpp"

namespace scenarios {
namespace fs = std::filesystem;

JobResult run_job(const std::vector<std::string>& arguments) {
  setenv("STEPFABRIC_BUILD_DIR", BUILD_DIRECTORY, 1);
  process::Start start{.arguments = {BUILD_DIRECTORY "/bin/stepfabric"}, .has_input = false};
  start.arguments.insert(start.arguments.end(), arguments.begin(), arguments.end());
  const process::Captured job = process::capture(start);
  return {.status = job.exit_status, .output = job.output};
}

fs::path scratch_folder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const fs::path folder = fs::path(BUILD_DIRECTORY) / "scenarios" / test->name();
  fs::create_directories(folder);
  return folder;
}

void write_file(const fs::path& file, const std::string& text) { files::write_text(file, text); }

bool Print::said(const std::string& text) const {
  if (!report.contains("messages")) return false;
  for (const auto& message : report["messages"]) {
    if (message["text"].get<std::string>().find(text) != std::string::npos) return true;
  }
  return false;
}

Print print_file(const fs::path& gcode, const std::vector<std::string>& options) {
  const fs::path folder = scratch_folder();
  const fs::path report = folder / "report";
  fs::remove_all(report);
  Print print;
  print.edges = folder / "edges.csv";
  std::vector<std::string> arguments{"print",         gcode.string(), "--report",
                                     report.string(), "--edges",      print.edges.string()};
  arguments.insert(arguments.end(), options.begin(), options.end());
  print.job = run_job(arguments);
  if (std::ifstream file(report / "report.json"); file) print.report = nlohmann::json::parse(file);
  return print;
}

Print print_text(const std::string& gcode, const std::vector<std::string>& options) {
  const fs::path file = scratch_folder() / "input.gcode";
  write_file(file, gcode);
  return print_file(file, options);
}

std::pair<int, int> expect_no_difference(const Print& print) {
  EXPECT_EQ(print.job.status, 0) << print.job.output;
  std::smatch found;
  const std::regex line(R"(replay: (\d+) of (\d+) intervals.*: 0 differ)");
  if (!std::regex_search(print.job.output, found, line)) {
    ADD_FAILURE() << print.job.output;
    return {};
  }
  std::printf("%s\n", found[0].str().c_str());
  EXPECT_EQ(print.job.output.find("could not be recorded"), std::string::npos);
  return {std::stoi(found[1]), std::stoi(found[2])};
}

}  // namespace scenarios
