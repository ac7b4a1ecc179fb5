// SPDX-License-Identifier: Apache-2.0
// processor_benchmark: the program behind `stepfabric bench processor`.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <string>

#include "tools/benchmark/processor_report.hpp"
#include "tools/files/write_file.hpp"

namespace {

// Whether the output is read or not.
void say_to(std::FILE* stream, const std::string& text) { std::fputs(text.c_str(), stream); }

}  // namespace

int main(int count, char** arguments) {
  benchmarks::ProcessorScope scope;
  std::filesystem::path json, report = "report";
  CLI::App app("Measures the processor on its works.");
  app.add_option("--programs", scope.programs, "folder of the programs")->required();
  app.add_option("--examples", scope.examples, "folder of the G-code files")->required();
  app.add_option("--json", json, "write the figures");
  app.add_option("--report", report, "folder for processor.html");
  app.add_option("--work", scope.works, "only this work; may be repeated; default: all");
  app.add_flag("--quick", scope.quick, "one iteration of each");
  CLI11_PARSE(app, count, arguments);
  std::signal(SIGPIPE, SIG_IGN);
  try {
    const auto figures = benchmarks::measure_processor(
        scope, [](const std::string& what) { say_to(stderr, "stepfabric: " + what + "\n"); });
    if (!json.empty()) files::write_file(json, benchmarks::to_json(figures));
    files::write_file(report / "processor.html", benchmarks::to_html(figures));
    say_to(stdout, fmt::format("{}report: {}\n", benchmarks::to_table(figures),
                               (report / "processor.html").string()));
  } catch (const std::exception& error) {
    say_to(stderr, fmt::format("stepfabric: {}\n", error.what()));
    return 1;
  }
  return 0;
}
