// SPDX-License-Identifier: Apache-2.0
// The options of the job `serve`, and what its help says.
#include "tools/command/printer_options.hpp"
#include "tools/command/serve_job.hpp"

namespace command {

void add_options(CLI::App& app, ServeOptions& options) {
  CLI::App& job = *app.add_subcommand(
      "serve", "Run the printer with its serial line on a pseudo-terminal, until Ctrl-C.");
  job.add_option("--pty", options.terminal,
                 "symlink to create, for host programs; must not exist. Default: "
                 "port in $XDG_RUNTIME_DIR/stepfabric, or in /tmp/stepfabric-USER")
      ->type_name("PATH");
  job.add_option_function<std::string>(
         "--speed", [&options](const std::string& speed) { options.real_time = speed == "real"; },
         "real: in real time (default); max: as fast as possible")
      ->check(CLI::IsMember({"real", "max"}));
  job.add_flag("--reset-on-open", options.reset_on_open,
               "opening the port resets the chip, as DTR does on an Arduino");
  job.add_option("--report", options.report, "folder for report.json and report.html")
      ->type_name("DIR")
      ->capture_default_str();
  job.add_option("--edges", options.edges,
                 "write every rising step edge: cycle,axis,direction,position")
      ->type_name("FILE.csv");
  job.add_option("--until", options.until_seconds, "stop after this many simulated seconds")
      ->type_name("S")
      ->check(CLI::PositiveNumber);
  job.add_option(
         "--clock-hz", options.clock_hz,
         "clock of the chip; default: the highest at which this machine simulates in real time "
         "(measured in a second)")
      ->check(CLI::Range(lowest_serve_clock_hz, highest_clock_hz));
  add_printer_options(job, options.printer);
  job.footer(
      R"(Any program that opens the port with the machine's baud rate can print; it may close and
open it again at any time. A slow clock changes no pulse. Exit status: 0 after Ctrl-C or --until,
1 a hardware assertion failed or a file could not be written, 2 bad usage, or it could not
start.)");
}

}  // namespace command
