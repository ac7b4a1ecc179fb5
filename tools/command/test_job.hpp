// SPDX-License-Identifier: Apache-2.0
// `test`: builds everything and runs the tests, or reports what they cost.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace command {

struct TestOptions {
  std::vector<std::string> labels;  // the tests that bear one of them; empty: all
  // Folder for costs.md and costs.json, of the last run of these tests; empty: tests are run.
  std::filesystem::path costs;
};

// Returns the exit status of the job. Throws where `costs` are wanted and no test was run.
int test(const TestOptions& options);

}  // namespace command
