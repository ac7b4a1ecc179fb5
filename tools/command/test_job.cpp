// SPDX-License-Identifier: Apache-2.0
// Calls of ctest, and what the last one has measured.
#include "tools/command/test_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <thread>

#include "tools/command/build.hpp"
#include "tools/command/exit_status.hpp"
#include "tools/command/signals.hpp"
#include "tools/figures/test_costs.hpp"
#include "tools/files/file_text.hpp"
#include "tools/files/write_text.hpp"

namespace command {

namespace {

constexpr std::size_t shown_tests = 10;

void write_costs(const std::filesystem::path& folder, const std::filesystem::path& last_run) {
  if (!std::filesystem::exists(last_run)) {
    throw std::runtime_error("all tests have not been run in this build: run `test` first");
  }
  const auto costs = figures::test_costs_of(files::text_of(last_run));
  std::filesystem::create_directories(folder);
  files::write_text(folder / "costs.md", figures::page_of(costs, shown_tests));
  files::write_text(folder / "costs.json", figures::json_of(costs));
}

// Before the tests, because jobs that they call would wait for a build by ctest. Where it fails,
// ctest builds it again, and those tests fail that need it.
void build_what_slow_tests_need() {
  try {
    build({"tested_late"});
  } catch (const Interrupted&) {
    throw;
  } catch (const std::runtime_error& error) {
    fmt::print(stderr, "stepfabric: {}\n", error.what());
  }
}

}  // namespace

int test(const TestOptions& options) {
  const bool all = options.labels.empty();
  const std::filesystem::path junit = build_folder() / (all ? "tests.xml" : "labelled_tests.xml");
  if (!options.costs.empty()) {
    write_costs(options.costs, junit);
    return success;
  }
  fmt::print(stderr, "stepfabric: building everything that is tested, log in {}\n",
             (build_folder() / "build.log").string());
  build({"all"});
  if (all) build_what_slow_tests_need();
  std::vector<std::string> arguments{
      "ctest",
      "--test-dir",
      build_folder().string(),
      "--output-on-failure",
      "--no-tests=error",
      "--output-junit",
      junit.string(),
      "--parallel",
      std::to_string(std::max(1U, std::thread::hardware_concurrency()))};
  // Tests of hours: ctest knows them only in this configuration.
  if (std::ranges::contains(options.labels, "nightly")) {
    arguments.insert(arguments.end(), {"--build-config", "nightly"});
  }
  if (!all) {
    arguments.insert(arguments.end(),
                     {"--label-regex", fmt::format("^({})$", fmt::join(options.labels, "|"))});
  }
  return run_program(arguments) == 0 ? success : failure;
}

}  // namespace command
