// SPDX-License-Identifier: Apache-2.0
// Runs the stepping benchmark on hardware and on software, and prints a file with both; the lines
// of the serial link; times the model of the chip, or uploads to the spooler; or runs the
// processor's benchmark, which is a program of its own.
#include "tools/command/bench_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "application/machine_description.hpp"
#include "tools/benchmark/lines_figures.hpp"
#include "tools/benchmark/link_figures.hpp"
#include "tools/benchmark/model_profile.hpp"
#include "tools/benchmark/model_speed.hpp"
#include "tools/benchmark/stepping_report.hpp"
#include "tools/benchmark/upload_speed.hpp"
#include "tools/command/build.hpp"
#include "tools/command/exit_status.hpp"
#include "tools/command/file_roles.hpp"
#include "tools/command/output.hpp"
#include "tools/command/print_job.hpp"
#include "tools/command/signals.hpp"
#include "tools/files/write_file.hpp"

namespace command {

namespace {

using benchmarks::Stepping;

// The clock of the print: at 50 MHz the simulation needs half a minute for each second.
constexpr std::uint32_t print_clock_hz = 16'000'000;

struct PrintOfBench {
  benchmarks::PrintFigure figure;
  nlohmann::json axes;
};

PrintOfBench print_with(Stepping stepping, const BenchOptions& options) {
  PrintOptions choices;
  choices.file = options.print_file;
  choices.report = options.report / name_of(stepping);
  choices.printer.clock_hz = print_clock_hz;
  choices.printer.stepping = name_of(stepping);
  choices.printer.warm = true;
  const int status = print(choices);
  if (status == interrupted) throw Interrupted();
  if (status != success) {
    throw std::runtime_error(fmt::format("the print with {} stepping failed", name_of(stepping)));
  }
  std::ifstream file(choices.report / "report.json");
  const auto report = nlohmann::json::parse(file);
  PrintOfBench result{.figure = {}, .axes = nlohmann::json::array()};
  result.figure.result = report["result"];
  result.figure.late_ticks = report["queue"]["late_ticks"];
  result.figure.underruns = report["queue"]["underruns"];
  result.figure.busy_percent = report["processor"]["busy_percent"];
  result.figure.max_deviation_mm = report["path"]["max_deviation_mm"];
  result.figure.seconds = report["simulated_seconds"];
  for (const auto& axis : report["axes"]) {
    result.figure.illegal_pulses += axis["illegal_pulses"].get<std::uint64_t>();
    result.figure.max_step_rate_hz =
        std::max(result.figure.max_step_rate_hz, axis["max_step_rate_hz"].get<double>());
    result.axes.push_back({axis["steps_forward"], axis["steps_backward"]});
  }
  return result;
}

void print_both(const BenchOptions& options, benchmarks::Comparison& comparison) {
  const PrintOfBench hardware = print_with(Stepping::hardware, options);
  PrintOfBench software = print_with(Stepping::software, options);
  software.figure.same_steps = software.axes == hardware.axes;
  comparison.print_clock_hz = print_clock_hz;
  comparison.print_file = options.print_file.filename().string();
  comparison.prints = {hardware.figure, software.figure};
  (*comparison.prints)[0].same_steps = true;
}

void show(const BenchOptions& options, const benchmarks::Comparison& comparison) {
  if (!options.json.empty()) files::write_file(options.json, benchmarks::to_json(comparison));
  files::write_file(options.report / "stepping.svg", benchmarks::to_svg(comparison));
  files::write_file(options.report / "stepping.html", benchmarks::to_html(comparison));
}

void note(const std::string& what) { say_to(stderr, "stepfabric: {}\n", what); }

std::filesystem::path programs_folder() { return build_folder() / "firmware"; }

sim::ElfImage image(const char* program, Stepping stepping) {
  return sim::read_elf(programs_folder() / fmt::format("{}_{}.elf", program, name_of(stepping)));
}

machine::Description description_of(const char* name) {
  return machine::read_description(project_folder() / "firmware" / "machines" / name);
}

std::filesystem::path short_print() {
  return project_folder() / "tools" / "benchmark" / "short_print.gcode";
}

int bench_stepping(const BenchOptions& options) {
  build({"stepping_benchmark_programs"});
  const benchmarks::Scope scope{
      .quick = options.quick, .tolerance_us = options.tolerance_us, .look = end_if_interrupted};
  benchmarks::Comparison comparison;
  comparison.clock_hz = scope.clock_hz;
  comparison.tolerance_us = scope.tolerance_us;
  const auto description = description_of("benchmark.toml");
  for (const Stepping stepping : {Stepping::hardware, Stepping::software}) {
    const auto index = static_cast<std::size_t>(stepping);
    comparison.figures[index] =
        benchmarks::measure(stepping, image("stepping_benchmark", stepping), scope, note);
    comparison.printing[index] = benchmarks::measure_printing(
        comparison.figures[index], {image("printing_benchmark", stepping), description}, scope,
        note);
  }
  // The print takes longest, so results so far are reported before it.
  show(options, comparison);
  if (!options.print_file.empty()) {
    print_both(options, comparison);
    show(options, comparison);
  }
  say("{}report: {}\n", benchmarks::to_table(comparison),
      (options.report / "stepping.html").string());
  return success;
}

int bench_processor(const BenchOptions& options) {
  build({"processor_benchmark", "processor_benchmark_programs"});
  std::vector<std::string> words{(build_folder() / "bin" / "processor_benchmark").string(),
                                 "--programs",
                                 programs_folder().string(),
                                 "--examples",
                                 (project_folder() / "examples").string(),
                                 "--report",
                                 options.report.string()};
  if (!options.json.empty()) words.insert(words.end(), {"--json", options.json.string()});
  if (options.quick) words.push_back("--quick");
  for (const std::string& work : options.works) words.insert(words.end(), {"--work", work});
  return run_program(words);
}

int bench_model(const BenchOptions& options) {
  build({"firmware", "processor_benchmark_programs"});
  const benchmarks::ModelScope scope{
      .firmware = sim::read_elf(programs_folder() / "firmware.elf"),
      .machine = description_of("prusa_mendel.toml"),
      .print_file = short_print(),
      .computing = sim::read_elf(programs_folder() / "core_benchmark.elf"),
      .quick = options.quick,
      .look = end_if_interrupted};
  const auto show_all = [&](const auto& works) {
    if (!options.json.empty()) files::write_file(options.json, benchmarks::to_json(works));
    say("{}", benchmarks::to_table(works));
  };
  if (options.profile) {
    show_all(benchmarks::profile_model(scope, note));
  } else {
    show_all(benchmarks::measure_model(scope, note));
  }
  return success;
}

int bench_link(const BenchOptions& options) {
  build({"link_benchmark_programs"});
  benchmarks::LinkScope scope{.firmware = {},
                              .machine = description_of("prusa_mendel.toml"),
                              .quick = options.quick,
                              .look = end_if_interrupted};
  for (const std::uint32_t baud : {250'000u, 1'000'000u, 3'000'000u}) {
    const auto program = programs_folder() / fmt::format("link_benchmark_{}.elf", baud);
    scope.firmware.emplace(baud, sim::read_elf(program));
  }
  const auto figures = benchmarks::measure_link(scope, note);
  if (!options.json.empty()) files::write_file(options.json, benchmarks::to_json(figures));
  say("{}", benchmarks::to_table(figures));
  return success;
}

int bench_lines(const BenchOptions& options) {
  build({"link_benchmark_programs"});
  benchmarks::LinesScope scope{.programs = {},
                               .machine = description_of("prusa_mendel.toml"),
                               .quick = options.quick,
                               .look = end_if_interrupted};
  for (const std::uint32_t baud : {1'000'000u, 3'000'000u}) {
    const auto program = [baud](const char* variant) {
      return programs_folder() / fmt::format("link_benchmark_{}{}.elf", baud, variant);
    };
    scope.programs.push_back({baud, CHIP_MEMORY_BYTES, program("")});
    scope.programs.push_back({baud, application::fast_memory_bytes, program("_fast")});
  }
  const auto figures = benchmarks::measure_lines(scope, note);
  if (!options.json.empty()) files::write_file(options.json, benchmarks::to_json(figures));
  say("{}", benchmarks::to_table(figures));
  return success;
}

int bench_upload(const BenchOptions& options) {
  benchmarks::UploadScope scope{.folder = options.report / "upload", .look = end_if_interrupted};
  if (options.quick) {
    scope.bytes = 10'000'000;
    scope.runs = 2;
  }
  const auto figures = benchmarks::measure_uploads(scope, note);
  if (!options.json.empty()) files::write_file(options.json, benchmarks::to_json(figures));
  say("{}", benchmarks::to_table(figures));
  return success;
}

int bench_one(const std::string& name, const BenchOptions& options) {
  if (name == "stepping") return bench_stepping(options);
  if (name == "model") return bench_model(options);
  if (name == "link") return bench_link(options);
  if (name == "lines") return bench_lines(options);
  if (name == "upload") return bench_upload(options);
  return bench_processor(options);
}

}  // namespace

int bench(const BenchOptions& options) {
  let_writes_fail();
  const std::array<NamedFile, 1> read{{{"--print", options.print_file}}};
  const std::array<NamedFile, 1> written{{{"--json", options.json}}};
  check_that_files_differ(read, written);
  BenchOptions chosen = options;
  if (chosen.profile && chosen.names != std::vector<std::string>{"model"}) {
    throw std::runtime_error("--profile is of the benchmark model: name it alone");
  }
  if (chosen.names.empty()) {
    chosen.names = {"lines", "link", "model", "processor", "stepping", "upload"};
  }
  if (chosen.names.size() > 1 && !chosen.json.empty()) {
    throw std::runtime_error("--json holds the figures of one benchmark: name it");
  }
  if (chosen.print_file.empty() && !chosen.quick) chosen.print_file = short_print();
  for (const std::string& name : chosen.names) {
    const int status = bench_one(name, chosen);
    if (status != success) return status;
  }
  return success;
}

}  // namespace command
