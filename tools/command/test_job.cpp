// SPDX-License-Identifier: Apache-2.0
// Calls of ctest.
#include "tools/command/test_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "tools/command/build.hpp"
#include "tools/command/exit_status.hpp"
#include "tools/figures/test_costs.hpp"
#include "tools/files/file_text.hpp"

namespace command {

namespace {

constexpr std::size_t shown_tests = 10;

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream stream(file);
  stream << text;
  if (!stream.flush()) throw std::runtime_error("cannot write " + file.string());
}

}  // namespace

int test(const TestOptions& options) {
  const std::filesystem::path junit = build_folder() / "tests.xml";
  fmt::print(stderr, "stepfabric: building everything that is tested, log in {}\n",
             (build_folder() / "build.log").string());
  build({"all"});
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
  if (!options.labels.empty()) {
    arguments.insert(arguments.end(),
                     {"--label-regex", fmt::format("^({})$", fmt::join(options.labels, "|"))});
  }
  const bool good = run_program(arguments) == 0;
  if (!options.costs.empty()) {
    const auto costs = figures::test_costs_of(files::text_of(junit));
    std::filesystem::create_directories(options.costs);
    write(options.costs / "costs.md", figures::page_of(costs, shown_tests));
    write(options.costs / "costs.json", figures::json_of(costs));
  }
  return good ? success : failure;
}

}  // namespace command
