// SPDX-License-Identifier: Apache-2.0
// Calls of ctest.
#include "tools/command/test_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <thread>

#include "tools/command/build.hpp"
#include "tools/command/exit_status.hpp"

namespace command {

int test(const std::vector<std::string>& labels) {
  fmt::print(stderr, "stepfabric: building everything that is tested, log in {}\n",
             (build_folder() / "build.log").string());
  build({"all"});
  std::vector<std::string> arguments{
      "ctest",
      "--test-dir",
      build_folder().string(),
      "--output-on-failure",
      "--no-tests=error",
      "--parallel",
      std::to_string(std::max(1U, std::thread::hardware_concurrency()))};
  if (!labels.empty()) {
    arguments.insert(arguments.end(),
                     {"--label-regex", fmt::format("^({})$", fmt::join(labels, "|"))});
  }
  return run_program(arguments) == 0 ? success : failure;
}

}  // namespace command
