// SPDX-License-Identifier: Apache-2.0
// Running the chip while a debugger halts and resumes it.
#include "tools/command/debug_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "sim/devices/debug_adapter.hpp"
#include "sim/devices/pseudo_terminal.hpp"
#include "tools/command/build.hpp"
#include "tools/command/exit_status.hpp"
#include "tools/command/output.hpp"
#include "tools/command/printer_setup.hpp"
#include "tools/command/run_job.hpp"
#include "tools/command/signals.hpp"

namespace command {

namespace {

constexpr double chunk_seconds = 0.005;
// Typical of PLA, for a warm start.
constexpr StartTemperatures warm_start{.hotend_c = 200.0, .bed_c = 57.0};

void greet(const std::filesystem::path& program, std::uint16_t port) {
  const std::filesystem::path enter = project_folder() / "tools" / "environment" / "enter.sh";
  say("{} runs; its JTAG pins wait for OpenOCD on port {} (remote_bitbang).\n"
      "  {} openocd -c 'set port {}' -f {}\n"
      "  {} gdb-multiarch {} -ex 'target extended-remote :3333'\n"
      "Ctrl-C ends it.\n",
      program.string(), port, enter.string(), port,
      (project_folder() / "tools" / "debug" / "simulation.cfg").string(), enter.string(),
      program.string());
  std::fflush(stdout);
}

int serve_debuggers(sim::Simulation& simulation, const DebugOptions& options,
                    const std::filesystem::path& program) {
  devices::DebugAdapter adapter(options.port, simulation.chip().inputs());
  const auto note = [&simulation](const char* what) {
    say_to(stderr, "{:10.4f} s  {}\n", simulation.seconds(), what);
  };
  adapter.on_connect = [&note](sim::Clock) { note("a debugger has connected"); };
  adapter.on_disconnect = [&note](sim::Clock) { note("the debugger has left"); };
  simulation.attach(adapter, sim::OutputPins::jtag_pin());
  greet(program, adapter.port());
  const sim::ClockRate rate = simulation.rate();
  const sim::Clock until = options.until_seconds ? rate.clocks(*options.until_seconds) : sim::never;
  while (!interrupt_requested() && simulation.now() < until) {
    simulation.run_until(std::min(simulation.now() + rate.clocks(chunk_seconds), until));
  }
  return success;
}

int debug_program(const DebugOptions& options) {
  const sim::ElfImage image = sim::read_elf(options.program);
  sim::VerilatedChip chip(options.printer.clock_hz);
  load(image, chip);
  make_start(image, chip);
  sim::Simulation simulation(chip, sim::ClockRate(options.printer.clock_hz));
  return serve_debuggers(simulation, options, options.program);
}

int debug_firmware(const DebugOptions& options) {
  PrinterSetup setup(options.printer, warm_start);
  std::optional<devices::PseudoTerminal> terminal;
  if (!options.terminal.empty()) {
    terminal.emplace(options.terminal, setup.printer().serial_line(), setup.simulation().rate(),
                     setup.baud());
    setup.simulation().attach(*terminal, {});
  }
  return serve_debuggers(setup.simulation(), options, build_folder() / "firmware" / "firmware.elf");
}

}  // namespace

int debug(const DebugOptions& options) {
  let_writes_fail();
  try {
    return options.program.empty() ? debug_firmware(options) : debug_program(options);
  } catch (const sim::HardwareAssertion& failed) {
    say_to(stderr, "stepfabric: {}\n", failed.what());
    return failure;
  }
}

}  // namespace command
