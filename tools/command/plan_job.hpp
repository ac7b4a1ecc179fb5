// SPDX-License-Identifier: Apache-2.0
// `plan`: time, steps and peaks of a print by the firmware's own planner, without simulation.
#pragma once

#include <cstdint>
#include <filesystem>

#include "tools/planning/plan_texts.hpp"

namespace CLI {
class App;
}

namespace command {

struct PlanOptions {
  std::filesystem::path file;
  std::filesystem::path machine;  // empty: the machine of the build
  std::filesystem::path json;  // empty: none
  std::filesystem::path commands;  // empty: not written
  planning::ListLimits limits{};
  std::filesystem::path path;  // empty: not written
  std::filesystem::path picture;  // empty: not written
  std::uint32_t clock_hz = 4'000'000;  // as `print` has it
};

// Adds the job to the program.
void add_options(CLI::App& app, PlanOptions& options);

// Returns the exit status of the job.
int plan(const PlanOptions& options);

}  // namespace command
