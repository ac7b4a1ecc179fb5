// SPDX-License-Identifier: Apache-2.0
// Chips with their programs and surroundings, and the time that this process has had for them.
#include "tools/benchmark/model_runs.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "firmware/benchmark/processor.hpp"
#include "sim/devices/file_host.hpp"
#include "sim/devices/pseudo_terminal.hpp"
#include "sim/machine/printer.hpp"
#include "sim/report/recorder.hpp"
#include "sim/simulation/simulation.hpp"
#include "sim/simulation/verilated_chip.hpp"
#include "tools/benchmark/terminal_host.hpp"
#include "tools/benchmark/window_host.hpp"
#include "tools/files/private_folder.hpp"

namespace benchmarks {

namespace {

// Simulated milliseconds: until the firmware has started; measured.
constexpr sim::Clock start_ms = 250, measured_ms = 2500, quick_ms = 50;
// For some hundred samples.
constexpr sim::Clock least_profiled_clocks = 60'000'000;
constexpr sim::Clock looks_clocks = 100'000;
constexpr double patience_seconds = 60;  // of the chip
constexpr std::uint32_t computing_without_end = 1'000'000'000;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double thread_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty() && line.front() != ';') lines.push_back(line);
  }
  if (lines.empty()) throw std::runtime_error(fmt::format("{} has no lines", file.string()));
  return lines;
}

sim::VerilatedChip made_chip(const ModelRun& run) {
  using enum ModelKind;
  const sim::Edges edges = run.kind == all_edges ? sim::Edges::all
                           : run.kind == resting ? sim::Edges::resting
                                                 : sim::Edges::leaping;
  return {run.clock_hz, edges, run.kind == usual ? sim::Processor::model : sim::Processor::netlist};
}

// A chip with a program, to be measured once.
class Bench {
 public:
  Bench(const ModelScope& scope, const ModelRun& run, const sim::ElfImage& program)
      : scope_(scope), run_(run), chip_(made_chip(run)) {
    sim::load(program, chip_);
  }

  sim::VerilatedChip& chip() { return chip_; }
  sim::Simulation& simulation() { return simulation_; }

  machine::Printer& printer() {
    if (!printer_) {
      const machine::PrinterOptions options{
          .baud = scope_.machine.baud, .hotend_start_c = 25, .bed_start_c = 25, .faults = {}};
      printer_.emplace(scope_.machine, options, simulation_);
    }
    return *printer_;
  }

  void run(sim::Clock clocks) {
    const sim::Clock end = simulation_.now() + clocks;
    while (simulation_.now() < end) {
      scope_.look();
      simulation_.run_until(std::min(end, simulation_.now() + looks_clocks));
    }
  }

  Measured measure() {
    const sim::Clock clocks_per_ms = simulation_.rate().hertz() / 1000;
    run(start_ms * clocks_per_ms);
    Measured measured;
    std::optional<ActivitySamples> samples;
    if (run_.profiled) {
      chip_.count_into(evaluations_);
      samples.emplace();
    }
    const sim::Clock begin = simulation_.now();
    const sim::ProcessorStatistics before = chip_.processor_statistics();
    const double started = processor_seconds();
    const double thread_started = thread_seconds();
    const sim::Clock clocks = (scope_.quick ? quick_ms : measured_ms) * clocks_per_ms;
    run(run_.profiled && !scope_.quick ? std::max(clocks, least_profiled_clocks) : clocks);
    measured.seconds = processor_seconds() - started;
    measured.clocks = simulation_.now() - begin;
    if (samples) {
      measured.profile = {.seconds = thread_seconds() - thread_started,
                          .samples = samples->counts(),
                          .evaluations = evaluations_};
    }
    const sim::ProcessorStatistics after = chip_.processor_statistics();
    measured.processor = {.sleeping_clocks = after.sleeping_clocks - before.sleeping_clocks,
                          .instructions = after.instructions - before.instructions};
    return measured;
  }

 private:
  const ModelScope& scope_;
  ModelRun run_;
  sim::VerilatedChip chip_;
  sim::EvaluationCounts evaluations_;
  sim::Simulation simulation_{chip_, sim::ClockRate(run_.clock_hz)};
  std::optional<machine::Printer> printer_;
};

void check(const std::string& complaint) {
  if (!complaint.empty()) {
    throw std::runtime_error(fmt::format("a line was refused: {}", complaint));
  }
}

// With a host and a report as `print` has them.
Measured run_recorded_print(const ModelScope& scope, const ModelRun& run) {
  Bench bench(scope, run, scope.firmware);
  const auto commands = devices::read_gcode_file(scope.print_file);
  if (!commands) throw std::runtime_error(commands.error());
  sim::Simulation& simulation = bench.simulation();
  devices::FileHost host(*commands, bench.printer().serial_line(), simulation.rate());
  simulation.attach(host, {}, sim::Activity::host_and_report);
  const report::Recorder recorder(bench.printer(), host, simulation, {});
  const Measured measured = bench.measure();
  check(host.fault());
  return measured;
}

}  // namespace

Measured run_asleep(const ModelScope& scope, const ModelRun& run) {
  Bench bench(scope, run, scope.firmware);
  bench.printer();
  return bench.measure();
}

Measured run_printing(const ModelScope& scope, const ModelRun& run) {
  if (run.profiled) return run_recorded_print(scope, run);
  Bench bench(scope, run, scope.firmware);
  const WindowHost host(lines_of(scope.print_file), bench.printer().serial_line());
  const Measured measured = bench.measure();
  check(host.complaint());
  return measured;
}

Measured run_served(const ModelScope& scope, const ModelRun& run) {
  Bench bench(scope, run, scope.firmware);
  sim::Simulation& simulation = bench.simulation();
  devices::PseudoTerminal terminal(
      files::PrivateFolder().path() / fmt::format("benchmark-{}", getpid()),
      bench.printer().serial_line(), simulation.rate(), scope.machine.baud);
  simulation.attach(terminal, {}, sim::Activity::host_and_report);
  TerminalHost host(terminal.slave_path(), lines_of(scope.print_file));
  // It runs in real time, not in the chip's.
  while (!host.greeted()) {
    bench.run(looks_clocks);
    if (simulation.now() > simulation.rate().clocks(patience_seconds)) {
      throw std::runtime_error("the host was not greeted");
    }
  }
  const Measured measured = bench.measure();
  host.stop();
  check(host.complaint());
  return measured;
}

Measured run_computing(const ModelScope& scope, const ModelRun& run) {
  Bench bench(scope, run, scope.computing);
  const auto order = scope.computing.symbol("benchmark_order");
  if (!order) throw std::runtime_error("the program has no symbol benchmark_order");
  bench.chip().write_memory(*order, computing_without_end);
  return bench.measure();
}

}  // namespace benchmarks
