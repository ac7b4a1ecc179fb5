// SPDX-License-Identifier: Apache-2.0
// Runs a job of the `stepfabric` program as a user does, and reads its report.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace scenarios {

struct JobResult {
  int status{};
  std::string output;  // both streams
};

JobResult run_job(const std::vector<std::string>& arguments);

// A folder of its own for the running test, empty at its start.
std::filesystem::path scratch_folder();

void write_file(const std::filesystem::path& file, const std::string& text);

struct Print {
  JobResult job;
  nlohmann::json report;  // null where there is none
  std::filesystem::path edges;

  // Whether the chip said something that contains this.
  bool said(const std::string& text) const;
};

// Prints G-code that is given as text, or a file of the project.
Print print_text(const std::string& gcode, const std::vector<std::string>& options = {});
Print print_file(const std::filesystem::path& gcode, const std::vector<std::string>& options = {});

// Of the line that a job with --replay says: intervals replayed, and how many there were. Each time
// others are chosen; where one differs, the output says which, and the seed to choose it again.
std::pair<int, int> expect_no_difference(const Print& print);

}  // namespace scenarios
