// SPDX-License-Identifier: Apache-2.0
// Running the printer for host programs, in step with the clock on the wall if asked.
#include "tools/command/serve_job.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <thread>

#include "sim/devices/pseudo_terminal.hpp"
#include "tools/command/exit_status.hpp"
#include "tools/command/printer_setup.hpp"
#include "tools/command/signals.hpp"

namespace command {

namespace {

using Time = std::chrono::steady_clock;

constexpr double chunk_seconds = 0.005;
// Typical of PLA, for a warm start.
constexpr StartTemperatures warm_start{.hotend_c = 200.0, .bed_c = 57.0};

}  // namespace

int serve(const ServeOptions& options) {
  PrinterSetup setup(options.printer, warm_start);
  sim::Simulation& simulation = setup.simulation();
  const sim::ClockRate rate = simulation.rate();
  devices::PseudoTerminal terminal(options.terminal, setup.printer().serial_line(), rate);
  simulation.attach(terminal, {});
  fmt::print("serving {} on {} ({}), {} baud. Ctrl-C ends it.\n",
             setup.printer().description().name, options.terminal.string(), terminal.slave_path(),
             setup.baud());
  std::fflush(stdout);

  const sim::Clock chunk = rate.clocks(chunk_seconds);
  const Time::time_point started = Time::now();
  while (!interrupt_requested()) {
    simulation.run_until(simulation.now() + chunk);
    if (options.real_time) {
      std::this_thread::sleep_until(started +
                                    std::chrono::duration_cast<Time::duration>(
                                        std::chrono::duration<double>(simulation.seconds())));
    }
  }
  const double wall = std::chrono::duration<double>(Time::now() - started).count();
  fmt::print("\n{:.1f} s on the printer in {:.1f} s, {:.2f} million clocks/s\n",
             simulation.seconds(), wall, static_cast<double>(simulation.now()) / wall * 1e-6);
  return success;
}

}  // namespace command
