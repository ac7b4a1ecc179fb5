// SPDX-License-Identifier: Apache-2.0
// `test`: builds everything and runs the tests.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace command {

struct TestOptions {
  std::vector<std::string> labels;  // the tests that bear one of them; empty: all
  std::filesystem::path costs;  // folder for costs.md and costs.json; empty: neither is written
};

// Returns the exit status of the job.
int test(const TestOptions& options);

}  // namespace command
