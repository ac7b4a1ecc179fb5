// SPDX-License-Identifier: Apache-2.0
// One print from the file to the report.
#include "tools/command/print_job.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <functional>
#include <optional>

#include "sim/devices/file_host.hpp"
#include "sim/devices/gcode_file.hpp"
#include "sim/report/accept_log.hpp"
#include "sim/report/gcode_path.hpp"
#include "sim/report/recorder.hpp"
#include "sim/report/verdict.hpp"
#include "tools/command/exit_status.hpp"
#include "tools/command/file_roles.hpp"
#include "tools/command/output.hpp"
#include "tools/command/print_summary.hpp"
#include "tools/command/printer_setup.hpp"
#include "tools/command/progress.hpp"
#include "tools/command/replay_check.hpp"
#include "tools/command/report_files.hpp"
#include "tools/command/signals.hpp"
#include "tools/command/warm_start.hpp"

namespace command {

namespace {

using Time = std::chrono::steady_clock;

// Between polls of Ctrl-C and updates of the progress line.
constexpr double chunk_seconds = 0.02;
// After the last answer: pulses end, and after a fault the heaters must be off.
constexpr double after_completion_seconds = 0.05;
constexpr double after_fault_seconds = 0.5;

// Input that cannot be printed is a result too: the report says so.
int refuse(const ReportFiles& reports, const std::string& reason) {
  reports.write_refusal(reason);
  say_to(stderr, "stepfabric: {}\n", reason);
  return bad_input;
}

ProgressFacts facts_of(PrinterSetup& setup, const devices::FileHost& host) {
  const machine::Printer& printer = setup.printer();
  return {host.done(),
          host.total(),
          setup.simulation().seconds(),
          setup.simulation().now(),
          printer.place_mm()[0],
          printer.place_mm()[1],
          printer.place_mm()[2],
          printer.hotend_c(),
          printer.bed_c()};
}

// How long anything moves, and for how much of that time the processor hardly sleeps and so limits
// the print.
class Saturation {
 public:
  void look(PrinterSetup& setup) {
    sim::Simulation& simulation = setup.simulation();
    const sim::Clock now = simulation.now();
    const std::uint64_t sleeping = simulation.chip().processor_statistics().sleeping_clocks;
    const std::uint64_t steps = steps_of(setup.printer());
    const auto clocks = static_cast<double>(now - seen_);
    if (steps != steps_) {
      const double seconds = simulation.rate().seconds(now - seen_);
      const bool saturated =
          static_cast<double>(sleeping - slept_) < (1.0 - saturated_share) * clocks;
      moving_seconds_ += seconds;
      saturated_seconds_ += saturated ? seconds : 0;
    }
    seen_ = now;
    slept_ = sleeping;
    steps_ = steps;
  }
  double moving_seconds() const { return moving_seconds_; }
  double saturated_seconds() const { return saturated_seconds_; }

 private:
  static constexpr double saturated_share = 0.98;

  static std::uint64_t steps_of(const machine::Printer& printer) {
    std::uint64_t steps = 0;
    for (std::size_t axis = 0; axis < printer.motors(); ++axis) {
      steps += printer.motor(axis).counts().forward + printer.motor(axis).counts().backward;
    }
    return steps;
  }

  sim::Clock seen_ = 0;
  std::uint64_t slept_ = 0;
  std::uint64_t steps_ = 0;
  double moving_seconds_ = 0;
  double saturated_seconds_ = 0;
};

// Runs to the end of the print. Returns how it ended.
report::Outcome run_print(const PrintOptions& options, PrinterSetup& setup, devices::FileHost& host,
                          Saturation& saturation, const std::function<bool()>& files_failed) {
  sim::Simulation& simulation = setup.simulation();
  const sim::ClockRate rate = simulation.rate();
  const sim::Clock chunk = std::max<sim::Clock>(1, rate.clocks(chunk_seconds));
  const sim::Clock until = options.until_seconds ? rate.clocks(*options.until_seconds) : sim::never;
  Progress progress;
  while (!host.ended() && simulation.now() < until && !interrupt_requested() && !files_failed()) {
    simulation.run_until(std::min(simulation.now() + chunk, until));
    saturation.look(setup);
    if (progress.due()) progress.show(facts_of(setup, host));
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

// Commands that were never acknowledged, unless the user stopped the print; and those acknowledged
// to the host that the firmware has not counted.
std::uint64_t lost_lines(report::Outcome outcome, const devices::FileHost& host,
                         const report::FirmwareWatch& watch) {
  std::uint64_t lost = 0;
  if (outcome != report::Outcome::stopped) {
    const devices::HostCounts& counts = host.counts();
    lost = host.commands() - counts.commands_executed - counts.commands_refused;
  }
  const std::uint64_t believed = host.counts().lines_executed;
  return lost + believed - std::min(believed, watch.commands_executed());
}

int exit_status_of(const report::Results& results) {
  if (results.outcome == report::Outcome::stopped && interrupt_requested()) return interrupted;
  return results.good() ? success : failure;
}

// That of the print, and of its replay where there is one. A difference is a failure even where the
// user interrupted the job.
int status_after_replay(int status, std::optional<ReplayCheck>& replay) {
  if (!replay) return status;
  std::fflush(stdout);  // The replays may take much longer than the print.
  const ReplayOutcome outcome = replay->finish();
  if (outcome == ReplayOutcome::different) return failure;
  if (status != success || outcome == ReplayOutcome::same) return status;
  return outcome == ReplayOutcome::cut_short ? interrupted : failure;
}

// Takes the place of the progress line.
void show_note(const std::string& note) {
  const bool terminal = isatty(STDERR_FILENO) != 0;
  say_to(stderr, "{}stepfabric: {}\n", terminal ? "\r\x1b[K" : "", note);
}

// Closes both files; returns the first error, or nothing.
std::string close_files(report::Recorder& recorder, std::optional<report::AcceptLog>& accept_log) {
  std::string complaint;
  const auto close = [&complaint](const std::function<void()>& closing) {
    try {
      closing();
    } catch (const std::runtime_error& error) {
      if (complaint.empty()) complaint = error.what();
    }
  };
  close([&] { recorder.close_edges(); });
  if (accept_log) close([&] { accept_log->close(); });
  return complaint;
}

void check_files(const PrintOptions& options) {
  const std::array<NamedFile, 2> read{
      {{"the G-code file", options.file}, {"--machine", options.printer.machine}}};
  const std::array<NamedFile, 5> written{{{"--report", options.report / "report.json"},
                                          {"--report", options.report / "report.html"},
                                          {"--edges", options.edges},
                                          {"--accept-log", options.printer.accept_log},
                                          {"--trace", options.trace}}};
  check_that_files_differ(read, written);
}

int print_and_report(const PrintOptions& options, const ReportFiles& reports) {
  const auto commands = devices::read_gcode_file(options.file);
  if (!commands) return refuse(reports, commands.error());
  StartTemperatures warm;
  if (options.printer.warm) warm = near_first_targets(*commands, description_of(options.printer));
  PrinterSetup setup(options.printer, warm);
  if (options.replay.asked &&
      setup.printer().description().memory_bytes.value_or(0) > CHIP_MEMORY_BYTES) {
    return refuse(reports,
                  "--replay needs the netlist, which has no more memory than the chip: the "
                  "machine's memory_kib is larger");
  }
  devices::FileHost host(
      *commands, setup.printer().serial_line(), setup.simulation().rate(),
      {.window = options.window, .answers_prompts = !options.no_answer, .note = show_note});
  setup.simulation().attach(host, {}, sim::Activity::host_and_report);
  report::Recorder recorder = opened(
      [&] { return report::Recorder(setup.printer(), host, setup.simulation(), options.edges); });
  report::FirmwareWatch watch(setup.firmware(), setup.chip());
  std::optional<report::AcceptLog> accept_log;
  if (!options.printer.accept_log.empty()) {
    opened([&] { accept_log.emplace(options.printer.accept_log); });
    watch.on_accepted = [&](sim::Clock, const report::AcceptedLine& line) {
      accept_log->put(line);
    };
    setup.simulation().attach(watch, {}, sim::Activity::host_and_report);
  }
  if (!options.trace.empty()) setup.chip().trace_to(options.trace);
  std::optional<ReplayCheck> replay;
  if (options.replay.asked) replay.emplace(options.replay, options.printer, setup.chip());

  const Time::time_point started = Time::now();
  report::Outcome outcome = report::Outcome::faulted;
  std::string fault;
  Saturation saturation;
  try {
    outcome = run_print(options, setup, host, saturation, [&] {
      return recorder.edges_failed() || (accept_log && accept_log->failed());
    });
    fault = host.fault();
  } catch (const std::exception& failed) {  // of the hardware, above all
    fault = failed.what();
  }
  if (const std::string complaint = close_files(recorder, accept_log); !complaint.empty()) {
    outcome = report::Outcome::faulted;
    fault = fault.empty() ? complaint : fault + "; " + complaint;
  }
  report::Results results = recorder.results(setup.firmware());
  results.file = options.file.filename().string();
  results.outcome = outcome;
  results.fault = fault;
  results.wall_seconds = std::chrono::duration<double>(Time::now() - started).count();
  results.moving_seconds = saturation.moving_seconds();
  results.processor_saturated_seconds = saturation.saturated_seconds();
  results.other_programs = watch.other_programs();
  results.gaps = watch.gaps();
  results.findings.lines_lost = lost_lines(outcome, host, watch);
  report::judge(results);
  const bool written = reports.write(results, recorder.courses());
  print_summary(options, results);
  const int status = status_after_replay(exit_status_of(results), replay);
  return written || status != success ? status : failure;
}

}  // namespace

int print(const PrintOptions& options) {
  let_writes_fail();
  check_files(options);
  const ReportFiles reports(options.report, options.file.filename().string(),
                            options.printer.clock_hz);
  try {
    return print_and_report(options, reports);
  } catch (const Interrupted& error) {
    reports.write_refusal(error.what());
    throw;
  } catch (const std::exception& error) {
    return refuse(reports, error.what());
  }
}

}  // namespace command
