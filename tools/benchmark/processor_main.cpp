// SPDX-License-Identifier: Apache-2.0
// processor_benchmark: the program behind `stepfabric bench processor`.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "sim/report/write_file.hpp"
#include "tools/benchmark/processor_report.hpp"

int main(int count, char** arguments) {
  benchmarks::ProcessorScope scope;
  std::filesystem::path json, report = "report";
  CLI::App app("Measures the processor on its works.");
  app.add_option("--programs", scope.programs, "folder of the programs")->required();
  app.add_option("--examples", scope.examples, "folder of the G-code files")->required();
  app.add_option("--json", json, "write the figures");
  app.add_option("--report", report, "folder for processor.html");
  app.add_flag("--quick", scope.quick, "one iteration of each");
  CLI11_PARSE(app, count, arguments);
  try {
    const auto figures = benchmarks::measure_processor(
        scope, [](const std::string& what) { fmt::print(stderr, "stepfabric: {}\n", what); });
    if (!json.empty()) report::write_file(json, benchmarks::to_json(figures));
    report::write_file(report / "processor.html", benchmarks::to_html(figures));
    fmt::print("{}report: {}\n", benchmarks::to_table(figures),
               (report / "processor.html").string());
  } catch (const std::exception& error) {
    fmt::print(stderr, "stepfabric: {}\n", error.what());
    return 1;
  }
  return 0;
}
