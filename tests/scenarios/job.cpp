// SPDX-License-Identifier: Apache-2.0
// Starts the `stepfabric` program of this build and collects what it leaves.
#include "tests/scenarios/job.hpp"
#include "directories.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace scenarios {
namespace {

namespace fs = std::filesystem;

std::string quoted(const std::string& word) {
  std::string result = "'";
  for (const char c : word) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

}  // namespace

JobResult run_job(const std::vector<std::string>& arguments) {
  std::string command = "STEPFABRIC_BUILD_DIR=" + quoted(BUILD_DIRECTORY) + " " +
                        quoted(std::string(BUILD_DIRECTORY) + "/bin/stepfabric");
  for (const std::string& argument : arguments) command += " " + quoted(argument);
  command += " 2>&1 < /dev/null";
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  JobResult result;
  std::array<char, 4096> buffer{};
  while (std::fgets(buffer.data(), buffer.size(), pipe) != nullptr) result.output += buffer.data();
  const int status = pclose(pipe);
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

fs::path scratch_folder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const fs::path folder = fs::path(BUILD_DIRECTORY) / "scenarios" / test->name();
  fs::create_directories(folder);
  return folder;
}

void write_file(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

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

}  // namespace scenarios
