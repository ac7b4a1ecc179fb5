// SPDX-License-Identifier: Apache-2.0
// One print from the file to the report.
#include "tools/command/print_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "sim/devices/file_host.hpp"
#include "sim/devices/gcode_file.hpp"
#include "sim/machine/thermal_properties.hpp"
#include "sim/report/accept_log.hpp"
#include "sim/report/gcode_path.hpp"
#include "sim/report/html_report.hpp"
#include "sim/report/json_report.hpp"
#include "sim/report/recorder.hpp"
#include "tools/command/exit_status.hpp"
#include "tools/command/printer_setup.hpp"
#include "tools/command/progress.hpp"
#include "tools/command/signals.hpp"

namespace command {

namespace {

using Time = std::chrono::steady_clock;

// Between looks at the keyboard and at the progress line.
constexpr double chunk_seconds = 0.02;
// After the last answer: pulses end, and after a fault one sees whether the heat is off.
constexpr double after_completion_seconds = 0.05;
constexpr double after_fault_seconds = 0.5;
// How far below its first target a warm start begins.
constexpr double warm_distance_c = 3.0;

void write_report(const PrintOptions& options, const report::Results& results,
                  const report::Courses& courses) {
  report::write_file(options.report / "report.json", report::to_json(results));
  report::write_file(options.report / "report.html", report::to_html(results, courses));
}

// Input that cannot be printed is a result too: the report says so.
int refuse(const PrintOptions& options, const std::string& reason) {
  report::Results results;
  results.file = options.file.filename().string();
  results.outcome = report::Outcome::faulted;
  results.fault = reason;
  results.clock_hz = options.printer.clock_hz;
  report::write_file(options.report / "report.json", report::to_json(results));
  fmt::print(stderr, "stepfabric: {}\n", reason);
  return bad_input;
}

StartTemperatures near_first_targets(const std::vector<devices::FileCommand>& commands) {
  StartTemperatures start{machine::ambient_celsius, machine::ambient_celsius};
  bool hotend_known = false, bed_known = false;
  report::GcodePath gcode;
  for (const devices::FileCommand& command : commands) {
    const report::Request request = gcode.read(command.text);
    const auto* target = std::get_if<report::TemperatureTarget>(&request);
    if (target == nullptr || target->celsius <= 0) {
      continue;
    }
    bool& known = target->bed ? bed_known : hotend_known;
    double& celsius = target->bed ? start.bed_c : start.hotend_c;
    if (!known) {
      celsius = std::max(machine::ambient_celsius, target->celsius - warm_distance_c);
      known = true;
    }
  }
  return start;
}

ProgressFacts facts_of(PrinterSetup& setup, const devices::FileHost& host) {
  const machine::Printer& printer = setup.printer();
  return {host.done(),
          host.total(),
          setup.simulation().seconds(),
          setup.simulation().now(),
          printer.axis(0).position_mm(),
          printer.axis(1).position_mm(),
          printer.axis(2).position_mm(),
          printer.hotend_c(),
          printer.bed_c()};
}

// Runs to the end of the print. Returns how it ended.
report::Outcome run_print(const PrintOptions& options, PrinterSetup& setup,
                          devices::FileHost& host) {
  sim::Simulation& simulation = setup.simulation();
  const sim::ClockRate rate = simulation.rate();
  const sim::Clock chunk = std::max<sim::Clock>(1, rate.clocks(chunk_seconds));
  const sim::Clock until = options.until_seconds ? rate.clocks(*options.until_seconds) : sim::never;
  Progress progress;
  while (!host.ended() && simulation.now() < until && !interrupt_requested()) {
    simulation.run_until(std::min(simulation.now() + chunk, until));
    if (progress.due()) {
      progress.show(facts_of(setup, host));
    }
  }
  report::Outcome outcome = report::Outcome::stopped;
  if (host.ended()) {
    const bool completed = host.state() == devices::HostState::completed;
    outcome = completed ? report::Outcome::completed : report::Outcome::faulted;
    simulation.run_until(simulation.now() +
                         rate.clocks(completed ? after_completion_seconds : after_fault_seconds));
  }
  progress.show(facts_of(setup, host));
  progress.finish();
  return outcome;
}

void print_summary(const PrintOptions& options, const report::Results& results) {
  fmt::print("{}: {}{}{}\n", results.file, name_of(results.outcome),
             results.fault.empty() ? "" : ": ", results.fault);
  fmt::print(
      "  {:.1f} s on the printer at {:.3g} MHz, simulated in {:.1f} s ({:.2f} million clocks/s)\n",
      results.simulated_seconds, results.clock_hz * 1e-6, results.wall_seconds,
      static_cast<double>(results.cycles) / std::max(results.wall_seconds, 1e-9) * 1e-6);
  fmt::print(
      "  {} lines, {} resends; {} of {} points reached to the step, at most {:.4f} mm off the "
      "lines\n",
      results.lines_sent, results.resends, results.points_reached,
      results.points_reached + results.points_missed, results.max_deviation_mm);
  std::uint64_t illegal = 0, lost = 0;
  for (const report::AxisResult& axis : results.axes) {
    illegal += axis.illegal_pulses;
    lost += axis.disabled_pulses + axis.slipped_steps + axis.frame_steps;
  }
  fmt::print(
      "  {} illegal pulses, {} steps lost otherwise, {} underruns, processor {:.1f} % busy\n",
      illegal, lost, results.underruns, results.processor_busy_percent);
  if (options.printer.stepping == "software") {
    fmt::print("  steps made in software: {} ticks were late\n", results.late_ticks);
  }
  fmt::print("  {} messages of the chip; report: {}\n", results.messages.size(),
             (options.report / "report.html").string());
}

int exit_status_of(const PrintOptions& options, report::Outcome outcome) {
  switch (outcome) {
    case report::Outcome::completed:
      return success;
    case report::Outcome::faulted:
      return failure;
    case report::Outcome::stopped:
      return options.until_seconds && !interrupt_requested() ? success : interrupted;
  }
  return failure;
}

}  // namespace

int print(const PrintOptions& options) {
  const auto commands = devices::read_gcode_file(options.file);
  if (!commands) {
    return refuse(options, commands.error());
  }
  std::filesystem::create_directories(options.report);  // fails now rather than after the print
  PrinterSetup setup(options.printer, near_first_targets(*commands));
  devices::FileHost host(*commands, setup.printer().serial_line(), setup.simulation().rate());
  setup.simulation().attach(host, {});
  report::Recorder recorder(setup.printer(), host, setup.simulation(), options.edges);
  report::FirmwareWatch watch(setup.firmware(), setup.chip());
  std::optional<report::AcceptLog> accept_log;
  if (!options.printer.accept_log.empty()) {
    accept_log.emplace(options.printer.accept_log);
    watch.on_accepted = [&](sim::Clock, const report::AcceptedLine& line) {
      accept_log->put(line);
    };
    setup.simulation().attach(watch, {});
  }
  if (!options.trace.empty()) {
    setup.chip().trace_to(options.trace);
  }

  const Time::time_point started = Time::now();
  report::Outcome outcome = report::Outcome::faulted;
  std::string fault;
  try {
    outcome = run_print(options, setup, host);
    fault = host.fault();
  } catch (const sim::HardwareAssertion& failed) {
    fault = failed.what();
  }
  report::Results results = recorder.results(setup.firmware());
  results.file = options.file.filename().string();
  results.outcome = outcome;
  results.fault = fault;
  results.wall_seconds = std::chrono::duration<double>(Time::now() - started).count();
  recorder.close_edges();
  if (accept_log) {
    accept_log->close();
  }
  write_report(options, results, recorder.courses());
  print_summary(options, results);
  return exit_status_of(options, outcome);
}

}  // namespace command
