// SPDX-License-Identifier: Apache-2.0
// Chooses the clock, serves, and writes the report.
#include "tools/command/serve_job.hpp"

#include <algorithm>
#include <array>

#include "sim/report/verdict.hpp"
#include "tools/command/clock_choice.hpp"
#include "tools/command/exit_status.hpp"
#include "tools/command/file_roles.hpp"
#include "tools/command/output.hpp"
#include "tools/command/report_files.hpp"
#include "tools/command/service.hpp"
#include "tools/command/signals.hpp"
#include "tools/files/private_folder.hpp"

namespace command {

namespace {

void choose_clock(ServeOptions& options) {
  if (options.clock_hz) {
    options.printer.clock_hz = *options.clock_hz;
  } else if (options.real_time) {
    const ClockChoice choice = clock_that_keeps_up(options.printer);
    options.printer.clock_hz = choice.clock_hz;
    say("this machine simulates {:.1f} million clocks/s of a print, so the chip gets {:.3g} "
        "MHz{}\n",
        choice.model_clocks_per_second * 1e-6, choice.clock_hz * 1e-6,
        choice.model_clocks_per_second < choice.clock_hz
            ? ", the lowest; it will not keep up with real time"
            : "");
  }
}

// Anything written to the port would be taken for lines of a host.
void check_files(const ServeOptions& options) {
  const std::array<NamedFile, 1> read{{{"--machine", options.printer.machine}}};
  const std::array<NamedFile, 5> written{{{"--report", options.report / "report.json"},
                                          {"--report", options.report / "report.html"},
                                          {"--edges", options.edges},
                                          {"--accept-log", options.printer.accept_log},
                                          {"--pty", options.terminal}}};
  check_that_files_differ(read, written);
}

int serve_and_report(ServeOptions& options, const ReportFiles& reports) {
  if (options.terminal.empty()) options.terminal = files::PrivateFolder().path() / "port";
  check_files(options);
  choose_clock(options);
  Service service(options);
  service.greet(reports.page());
  std::string fault;
  try {
    service.run();
  } catch (const std::exception& failed) {  // of the hardware, above all
    fault = failed.what();
  }
  if (const std::string complaint = service.close_files(); !complaint.empty()) {
    fault = fault.empty() ? complaint : fault + "; " + complaint;
  }
  report::Results results = service.results();
  results.fault = fault;
  if (!fault.empty()) {
    results.outcome = report::Outcome::faulted;
    say_to(stderr, "stepfabric: {}\n", fault);
  }
  report::judge(results);
  const bool written = reports.write(results, service.courses());
  say("{:.1f} s on the printer in {:.1f} s, {:.2f} million clocks/s; {} lines taken, {} "
      "resends; report: {}\n",
      results.simulated_seconds, results.wall_seconds,
      static_cast<double>(results.cycles) / std::max(results.wall_seconds, 1e-9) * 1e-6,
      results.lines_sent, results.resends, reports.page().string());
  return fault.empty() && written ? success : failure;
}

}  // namespace

int serve(ServeOptions options) {
  let_writes_fail();
  check_files(options);
  const ReportFiles reports(options.report, {}, options.clock_hz.value_or(0));
  try {
    return serve_and_report(options, reports);
  } catch (const Interrupted& error) {
    reports.write_refusal(error.what());
    throw;
  } catch (const std::exception& error) {
    reports.write_refusal(error.what());
    throw;
  }
}

}  // namespace command
