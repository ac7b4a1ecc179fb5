// SPDX-License-Identifier: Apache-2.0
// Times runs of the chip's model in processor time of this process.
#include "tools/benchmark/model_speed.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "firmware/benchmark/processor.hpp"
#include "sim/devices/pseudo_terminal.hpp"
#include "sim/machine/printer.hpp"
#include "sim/simulation/simulation.hpp"
#include "sim/simulation/verilated_chip.hpp"
#include "tools/benchmark/terminal_host.hpp"
#include "tools/benchmark/window_host.hpp"
#include "tools/files/private_folder.hpp"

namespace benchmarks {

namespace {

constexpr std::uint32_t clock_hz = 4'000'000;  // the default of `print`
constexpr std::uint32_t board_clock_hz = 50'000'000;
// Simulated milliseconds: until the firmware has started; measured.
constexpr sim::Clock start_ms = 250, measured_ms = 2500, quick_ms = 50;
constexpr sim::Clock looks_clocks = 100'000;
constexpr double patience_seconds = 60;  // of the chip
constexpr int runs = 3;
constexpr std::uint32_t computing_without_end = 1'000'000'000;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty() && line.front() != ';') lines.push_back(line);
  }
  if (lines.empty()) throw std::runtime_error(fmt::format("{} has no lines", file.string()));
  return lines;
}

struct Measured {
  double seconds{};
  sim::Clock clocks{};
  sim::ProcessorStatistics processor;
};

Measured measure(sim::Simulation& simulation, const ModelScope& scope) {
  const auto run = [&](sim::Clock clocks) {
    const sim::Clock end = simulation.now() + clocks;
    while (simulation.now() < end) {
      scope.look();
      simulation.run_until(std::min(end, simulation.now() + looks_clocks));
    }
  };
  const sim::Clock clocks_per_ms = simulation.rate().hertz() / 1000;
  run(start_ms * clocks_per_ms);
  const sim::Clock begin = simulation.now();
  const sim::ProcessorStatistics before = simulation.chip().processor_statistics();
  const double started = processor_seconds();
  run((scope.quick ? quick_ms : measured_ms) * clocks_per_ms);
  const double seconds = processor_seconds() - started;
  const sim::ProcessorStatistics after = simulation.chip().processor_statistics();
  return {.seconds = seconds,
          .clocks = simulation.now() - begin,
          .processor = {.sleeping_clocks = after.sleeping_clocks - before.sleeping_clocks,
                        .instructions = after.instructions - before.instructions}};
}

sim::VerilatedChip made_chip(std::uint32_t clock, ModelKind kind) {
  using enum ModelKind;
  const sim::Edges edges = kind == all_edges ? sim::Edges::all
                           : kind == resting ? sim::Edges::resting
                                             : sim::Edges::leaping;
  return {clock, edges, kind == usual ? sim::Processor::model : sim::Processor::netlist};
}

Measured run_firmware(const ModelScope& scope, ModelKind kind, bool prints,
                      std::uint32_t clock = clock_hz) {
  sim::VerilatedChip chip = made_chip(clock, kind);
  sim::load(scope.firmware, chip);
  sim::Simulation simulation(chip, sim::ClockRate(clock));
  machine::Printer printer(
      scope.machine,
      {.baud = scope.machine.baud, .hotend_start_c = 25, .bed_start_c = 25, .faults = {}},
      simulation);
  std::optional<WindowHost> host;
  if (prints) host.emplace(lines_of(scope.print_file), printer.serial_line());
  const Measured measured = measure(simulation, scope);
  if (host && !host->complaint().empty()) {
    throw std::runtime_error(fmt::format("a line was refused: {}", host->complaint()));
  }
  return measured;
}

// As in `serve`, at full speed: the host is another thread, whose time counts as well.
Measured run_served(const ModelScope& scope, ModelKind kind) {
  sim::VerilatedChip chip = made_chip(clock_hz, kind);
  sim::load(scope.firmware, chip);
  const sim::ClockRate rate(clock_hz);
  sim::Simulation simulation(chip, rate);
  machine::Printer printer(
      scope.machine,
      {.baud = scope.machine.baud, .hotend_start_c = 25, .bed_start_c = 25, .faults = {}},
      simulation);
  devices::PseudoTerminal terminal(
      files::PrivateFolder().path() / fmt::format("benchmark-{}", getpid()), printer.serial_line(),
      rate, scope.machine.baud);
  simulation.attach(terminal, {});
  TerminalHost host(terminal.slave_path(), lines_of(scope.print_file));
  // It runs in real time, not in the chip's.
  while (!host.greeted()) {
    scope.look();
    simulation.run_until(simulation.now() + looks_clocks);
    if (simulation.now() > rate.clocks(patience_seconds)) {
      throw std::runtime_error("the host was not greeted");
    }
  }
  const Measured measured = measure(simulation, scope);
  host.stop();
  if (!host.complaint().empty()) {
    throw std::runtime_error(fmt::format("a line was refused: {}", host.complaint()));
  }
  return measured;
}

Measured run_computing(const ModelScope& scope, ModelKind kind) {
  sim::VerilatedChip chip = made_chip(clock_hz, kind);
  sim::load(scope.computing, chip);
  const auto order = scope.computing.symbol("benchmark_order");
  if (!order) throw std::runtime_error("the program has no symbol benchmark_order");
  chip.write_memory(*order, computing_without_end);
  sim::Simulation simulation(chip, sim::ClockRate(clock_hz));
  return measure(simulation, scope);
}

using Run = std::function<Measured(ModelKind)>;

ModelWork measure_work(const std::string& name, std::uint32_t clock, const ModelScope& scope,
                       const Run& run) {
  ModelWork work{.name = name, .clock_hz = clock};
  for (int i = 0; i < (scope.quick ? 1 : runs); ++i) {
    for (const ModelKind kind :
         {ModelKind::usual, ModelKind::whole_netlist, ModelKind::resting, ModelKind::all_edges}) {
      // With many more clocks this would take minutes.
      if (clock != clock_hz && kind == ModelKind::all_edges) continue;
      const Measured measured = run(kind);
      const auto clocks = static_cast<double>(measured.clocks);
      double& best = work.clocks_per_second[static_cast<std::size_t>(kind)];
      best = std::max(best, clocks / std::max(measured.seconds, 1e-6));
      work.clocks = measured.clocks;
      work.awake = 1 - static_cast<double>(measured.processor.sleeping_clocks) / clocks;
      work.instructions_per_clock = static_cast<double>(measured.processor.instructions) / clocks;
    }
  }
  return work;
}

}  // namespace

std::vector<ModelWork> measure_model(const ModelScope& scope,
                                     const std::function<void(const std::string&)>& say) {
  std::vector<ModelWork> works;
  const auto add = [&](const std::string& name, const Run& run, std::uint32_t clock = clock_hz) {
    say(fmt::format("the model, {}", name));
    works.push_back(measure_work(name, clock, scope, run));
  };
  add("asleep", [&](ModelKind kind) { return run_firmware(scope, kind, false); });
  add("printing", [&](ModelKind kind) { return run_firmware(scope, kind, true); });
  add(
      "printing at 50 MHz",
      [&](ModelKind kind) { return run_firmware(scope, kind, true, board_clock_hz); },
      board_clock_hz);
  add("serving", [&](ModelKind kind) { return run_served(scope, kind); });
  add("computing", [&](ModelKind kind) { return run_computing(scope, kind); });
  return works;
}

std::string to_json(const std::vector<ModelWork>& works) {
  nlohmann::ordered_json json{{"benchmark", "model"}};
  for (const ModelWork& work : works) {
    json["works"].push_back(
        {{"name", work.name},
         {"clock_hz", work.clock_hz},
         {"clocks", work.clocks},
         {"awake", work.awake},
         {"instructions_per_clock", work.instructions_per_clock},
         {"clocks_per_second", work.speed(ModelKind::usual)},
         {"clocks_per_second_processor_by_netlist", work.speed(ModelKind::whole_netlist)},
         {"clocks_per_second_without_leaps", work.speed(ModelKind::resting)},
         {"clocks_per_second_all_edges", work.speed(ModelKind::all_edges)}});
  }
  return json.dump(2) + "\n";
}

std::string to_table(const std::vector<ModelWork>& works) {
  std::string table =
      fmt::format("{:<20} {:>7} {:>13} {:>10} {:>13} {:>10} {:>10} {:>10}\n", "", "awake",
                  "instructions", "million", "processor", "without", "all edges", "simulated");
  table += fmt::format("{:<20} {:>7} {:>13} {:>10} {:>13} {:>10} {:>10} {:>10}\n", "", "",
                       "per clock", "clocks/s", "by netlist", "leaps", "", "s per s");
  for (const ModelWork& work : works) {
    const double speed = work.speed(ModelKind::usual);
    table += fmt::format(
        "{:<20} {:>6.1f}% {:>13.3f} {:>10.2f} {:>13.2f} {:>10.2f} {:>10.2f} {:>10.2f}\n", work.name,
        100 * work.awake, work.instructions_per_clock, speed * 1e-6,
        work.speed(ModelKind::whole_netlist) * 1e-6, work.speed(ModelKind::resting) * 1e-6,
        work.speed(ModelKind::all_edges) * 1e-6, speed / work.clock_hz);
  }
  return table;
}

}  // namespace benchmarks
