// SPDX-License-Identifier: Apache-2.0
// The `stepfabric` program: one job per call, its options, its exit status.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string_view>

#include "sim/machine/fault_plan.hpp"
#include "tools/command/bench_job.hpp"
#include "tools/command/build.hpp"
#include "tools/command/debug_job.hpp"
#include "tools/command/exit_status.hpp"
#include "tools/command/fuzz_job.hpp"
#include "tools/command/load_job.hpp"
#include "tools/command/output.hpp"
#include "tools/command/print_job.hpp"
#include "tools/command/run_job.hpp"
#include "tools/command/serve_job.hpp"
#include "tools/command/signals.hpp"
#include "tools/command/test_job.hpp"
#include "tools/proof/run.hpp"
#include "tools/synthesis/job.hpp"

namespace command {

namespace {

constexpr std::uint32_t lowest_clock_hz = 4'000'000;
constexpr std::uint32_t highest_clock_hz = 100'000'000;
// As many lines as the firmware keeps waiting.
constexpr std::size_t most_window = 8;

struct Jobs {
  PrintOptions print;
  ServeOptions serve;
  RunOptions run;
  LoadOptions load;
  proof::Options prove;
  synthesis::Options synth;
  BenchOptions bench;
  DebugOptions debug;
  FuzzOptions fuzz;
  std::vector<std::string> labels;
};

void add_printer_options(CLI::App& job, PrinterChoices& choices) {
  job.add_option(
         "--machine", choices.machine,
         "description of the simulated printer (TOML); the firmware is built for the default")
      ->type_name("FILE.toml");
  job.add_option("--baud", choices.baud,
                 "baud rate of the serial line, at both ends; default: the machine's. At most a "
                 "quarter of the clock")
      ->check(CLI::Range(1'200, 3'000'000));
  job.add_option("--seed", choices.seed,
                 "seed of all that is random: start position, tolerances, noise")
      ->capture_default_str();
  job.add_flag("--warm", choices.warm,
               "the heaters start near their targets, which saves simulated minutes");
  job.add_option("--accept-log", choices.accept_log,
                 "write each line that the firmware took: <number or ->TAB<command>")
      ->type_name("FILE");
  job.add_option(
         "--fault", choices.faults,
         "break a part; may be given several times:\n" + std::string(machine::fault_forms()))
      ->type_name("FAULT");
}

void add_print(CLI::App& app, PrintOptions& options) {
  CLI::App& job = *app.add_subcommand("print", "Print a G-code file on the simulated printer.");
  job.add_option("file", options.file, "the G-code file")->required()->type_name("FILE.gcode");
  job.add_option("--report", options.report, "folder for report.json and report.html")
      ->type_name("DIR")
      ->capture_default_str();
  job.add_option("--edges", options.edges,
                 "write every rising step edge: cycle,axis,direction,position")
      ->type_name("FILE.csv");
  job.add_option("--trace", options.trace, "write all signals of the chip; slow, and large")
      ->type_name("FILE.fst");
  job.add_option("--stepping", options.printer.stepping,
                 "who makes the steps; software: the processor, in its timer interrupt")
      ->check(CLI::IsMember({"hardware", "software"}))
      ->capture_default_str();
  job.add_option("--until", options.until_seconds, "stop after so many simulated seconds")
      ->type_name("S")
      ->check(CLI::PositiveNumber);
  job.add_option("--clock-hz", options.printer.clock_hz, "clock of the chip")
      ->check(CLI::Range(lowest_clock_hz, highest_clock_hz))
      ->capture_default_str();
  job.add_option("--window", options.window,
                 "lines sent and not answered yet; 1 as Printrun and OctoPrint, 4 as Cura")
      ->check(CLI::Range(std::size_t{1}, most_window))
      ->capture_default_str();
  job.add_flag("--no-answer", options.no_answer,
               "do not answer M0 and M1 (as a user who presses Continue at once): end there");
  add_printer_options(job, options.printer);
  job.footer(
      "The file is sent as a host does it: without comments, with the host's own line numbers and\n"
      "checksums; M110 is not sent, and a number or a right checksum in the file is taken off.\n\n"
      "Exit status: 0 the print is good: all of the file (or, with --until, of what was sent by "
      "then)\n"
      "was made to the step. 1 it is bad: it faulted; the chip refused or lost a line that should "
      "move\n"
      "or heat; X, Y, Z or E was not at its step at the end of a line; the queue ran dry; a pulse "
      "was\n"
      "illegal or a step lost. 2 bad usage or a file that cannot be printed. 130 interrupted. From "
      "the\n"
      "begin on the folder has a report of this job alone: one that says that it has not ended, "
      "until "
      "it has.\n"
      "Only bad usage leaves an earlier one there. Refused lines that move and heat nothing are "
      "warnings.");
}

void add_serve(CLI::App& app, ServeOptions& options) {
  CLI::App& job = *app.add_subcommand(
      "serve", "Put the printer's serial line on a pseudo-terminal, until Ctrl-C.");
  job.add_option("--pty", options.terminal,
                 "symlink to make, for host programs to open; nothing may stand there. Default: "
                 "port in $XDG_RUNTIME_DIR/stepfabric, or in /tmp/stepfabric-USER")
      ->type_name("PATH");
  job.add_option_function<std::string>(
         "--speed", [&options](const std::string& speed) { options.real_time = speed == "real"; },
         "real: in step with the clock on the wall (default); max: as fast as it goes")
      ->check(CLI::IsMember({"real", "max"}));
  job.add_flag("--reset-on-open", options.reset_on_open,
               "opening the port resets the chip, as DTR does on an Arduino");
  job.add_option("--report", options.report, "folder for report.json and report.html")
      ->type_name("DIR")
      ->capture_default_str();
  job.add_option("--edges", options.edges,
                 "write every rising step edge: cycle,axis,direction,position")
      ->type_name("FILE.csv");
  job.add_option("--until", options.until_seconds, "stop after so many simulated seconds")
      ->type_name("S")
      ->check(CLI::PositiveNumber);
  job.add_option(
         "--clock-hz", options.clock_hz,
         "clock of the chip; default: the highest with which this machine keeps up with real "
         "time, which takes a second to find out")
      ->check(CLI::Range(lowest_serve_clock_hz, highest_clock_hz));
  add_printer_options(job, options.printer);
  job.footer(
      "Any program that opens the port with the machine's baud rate can print; it may close and "
      "open it\n"
      "again at any time. A slow clock changes no pulse. Exit status: 0 after Ctrl-C or --until, 1 "
      "where\n"
      "the hardware failed an assertion or the disk did not take all files, 2 bad usage, or it "
      "could "
      "not begin.");
}

void add_run(CLI::App& app, RunOptions& options) {
  CLI::App& job = *app.add_subcommand("run", "Run a bare-metal RV32IMC program on the chip.");
  job.add_option("program", options.program,
                 "linked to 0x80000000, 96 KiB; ends by a store to `tohost`")
      ->required()
      ->type_name("PROGRAM.elf");
  job.add_option("--max-cycles", options.max_cycles, "give up after so many clocks")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  job.add_option("--clock-hz", options.clock_hz, "clock that the chip reports to the program")
      ->check(CLI::Range(lowest_clock_hz, highest_clock_hz))
      ->capture_default_str();
  job.add_option("--baud", options.baud,
                 "show what the program sends on the serial line at this rate")
      ->check(CLI::Range(1'200, 3'000'000));
  job.add_option("--signature", options.signature,
                 "write the words from `begin_signature` to `end_signature` at the program's end, "
                 "for the architecture tests")
      ->type_name("FILE");
  job.add_option("--trace", options.trace, "write all signals of the chip")->type_name("FILE.fst");
  job.footer(
      "Exit status: the program's, which is 0 where 1 was stored to `tohost`, otherwise the value "
      ">> 1; from\n"
      "123 on it is 123, and the output says the real one. Above that it is this command's: 124 "
      "nothing was\n"
      "stored within --max-cycles, 125 bad usage or a file that is no such program, 130 "
      "interrupted.");
}

void add_load(CLI::App& app, LoadOptions& options) {
  CLI::App& job = *app.add_subcommand("load", "Load a program into a chip over its serial line.");
  job.add_option("program", options.program, "ELF file, or the plain contents of the memory")
      ->required()
      ->type_name("FILE");
  job.add_option("port", options.port, "the serial port, or the pseudo-terminal of `serve`")
      ->required()
      ->type_name("PORT");
  job.add_option("--baud", options.baud, "speed of the line")
      ->check(CLI::Range(1'200, 3'000'000))
      ->capture_default_str();
  job.footer(
      "The running firmware is asked with M997; where it does not answer, reset the board: the "
      "boot "
      "loader\n"
      "listens for 10 ms after a reset. Exit status: 0 the chip has checked the program and starts "
      "it, 1 not,\n"
      "and then it starts none, 2 bad usage or no such program.");
}

void add_bench(CLI::App& app, BenchOptions& options) {
  CLI::App& job = *app.add_subcommand(
      "bench",
      "Measure, in clocks: how hardware and software make steps, how fast the processor is, how "
      "many "
      "lines go through the serial line; and how fast the model of the chip runs here.");
  job.add_option("names", options.names, "stepping, processor, model, link; default: all")
      ->type_name("NAME...")
      ->check(CLI::IsMember({"stepping", "processor", "model", "link"}));
  job.add_option("--json", options.json, "write the figures")->type_name("FILE");
  job.add_option("--report", options.report, "folder for the pages: stepping.html, processor.html")
      ->type_name("DIR")
      ->capture_default_str();
  job.add_option("--print", options.print_file,
                 "the whole print to make with both; default: a short one")
      ->type_name("FILE.gcode")
      ->check(CLI::ExistingFile);
  job.add_option("--tolerance-us", options.tolerance_us,
                 "stepping: a tick is punctual up to so long after its exact instant")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  job.add_flag("--quick", options.quick, "few and short runs, to see that everything works");
}

void add_debug(CLI::App& app, DebugOptions& options) {
  CLI::App& job = *app.add_subcommand(
      "debug", "Run the chip with its JTAG pins in the hands of OpenOCD and gdb, until Ctrl-C.");
  job.add_option("program", options.program,
                 "as for `run`; default: the firmware, on the simulated printer")
      ->type_name("PROGRAM.elf");
  job.add_option("--port", options.port, "TCP port for OpenOCD's remote_bitbang; 0: any free one")
      ->capture_default_str();
  job.add_option("--pty", options.terminal, "symlink to the firmware's serial line, for a host")
      ->type_name("PATH");
  job.add_option("--until", options.until_seconds, "stop after so many simulated seconds")
      ->type_name("S")
      ->check(CLI::PositiveNumber);
  job.add_option("--clock-hz", options.printer.clock_hz, "clock of the chip")
      ->check(CLI::Range(lowest_serve_clock_hz, highest_clock_hz))
      ->capture_default_str();
  add_printer_options(job, options.printer);
  job.footer(
      "Says how to connect OpenOCD and gdb (tools/debug). While the processor is halted the rest "
      "of "
      "the\n"
      "chip goes on: the heaters' watchdog switches them off, as it does for software that hangs.\n"
      "Exit status: 0 after Ctrl-C or --until, 1 where the hardware failed an assertion, 2 bad "
      "usage.");
}

void add_fuzz(CLI::App& app, FuzzOptions& options) {
  CLI::App& job = *app.add_subcommand(
      "fuzz",
      "Run the fuzz targets (tests/fuzz) for long; `test fuzz` runs each for some seconds.");
  job.add_option("targets", options.targets, "boot_loader, firmware, host_link, ...; default: all")
      ->type_name("TARGET...");
  job.add_option("--executions", options.executions, "inputs of each target")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  job.add_option("--seed", options.seed, "of the mutations; 0: another one each time")
      ->capture_default_str();
  job.add_flag("--minimise", options.minimise,
               "then keep in tests/fuzz/corpus the fewest inputs that go wherever all go");
  job.footer(
      "New inputs are kept in <build>/fuzz/corpus/TARGET, from where the next run goes on; one "
      "that\n"
      "violates a property in <build>/fuzz/findings. Exit status: 0 none does, 1 one does, 2 bad "
      "usage.");
}

// Waveforms and the debug port need other builds of the chip's model, which slow nothing else down.
[[noreturn]] void become_other_program(const std::string& name, const char* model, int count,
                                       char** arguments) {
  fmt::print(stderr, "stepfabric: building the model that {}\n", model);
  build({name});
  std::vector<std::string> words{(build_folder() / "bin" / name).string()};
  words.insert(words.end(), arguments + 1, arguments + count);
  become_program(words);
}

bool this_is_program(const char* path, std::string_view name) {
  return std::string_view(path).ends_with(name);
}

int do_job(const CLI::App& app, const Jobs& jobs, int count, char** arguments) {
  const bool traces = !jobs.print.trace.empty() || !jobs.run.trace.empty();
  if (traces && !this_is_program(arguments[0], "stepfabric_traced")) {
    become_other_program("stepfabric_traced", "writes waveforms", count, arguments);
  }
  if (app.got_subcommand("debug")) {
    if (!this_is_program(arguments[0], "stepfabric_debug")) {
      become_other_program("stepfabric_debug", "has the debug port", count, arguments);
    }
    return debug(jobs.debug);
  }
  if (app.got_subcommand("print")) {
    return print(jobs.print);
  }
  if (app.got_subcommand("serve")) {
    return serve(jobs.serve);
  }
  if (app.got_subcommand("run")) {
    return run(jobs.run);
  }
  if (app.got_subcommand("load")) {
    return load(jobs.load);
  }
  if (app.got_subcommand("bench")) {
    return bench(jobs.bench);
  }
  if (app.got_subcommand("fuzz")) {
    return fuzz(jobs.fuzz);
  }
  if (app.got_subcommand("test")) {
    return test(jobs.labels);
  }
  if (app.got_subcommand("prove")) {
    return proof::prove(jobs.prove, project_folder(), build_folder()) ? success : failure;
  }
  build({"firmware"});  // synth
  const auto firmware = build_folder() / "firmware" / "firmware.elf";
  return synthesis::synthesize(jobs.synth, project_folder(), firmware) ? success : failure;
}

// `run` leaves the low ones to its program.
int bad_input_of(int count, char** arguments) {
  return count > 1 && std::string_view(arguments[1]) == "run" ? not_run : bad_input;
}

int run_command(int count, char** arguments) {
  CLI::App app("StepFabric: an FPGA motion controller for 3D printers, and its co-simulation.",
               "stepfabric");
  app.require_subcommand(1);
  Jobs jobs;
  add_print(app, jobs.print);
  add_serve(app, jobs.serve);
  add_run(app, jobs.run);
  add_load(app, jobs.load);
  app.add_subcommand("test", "Build everything and run all tests, or those of some labels.")
      ->add_option("labels", jobs.labels, "unit, testbench, repository, scenario, fuzz, ...")
      ->type_name("LABEL...");
  add_fuzz(app, jobs.fuzz);
  proof::add_options(
      *app.add_subcommand("prove", "Try the formal proofs, and that each of them bites."),
      jobs.prove);
  synthesis::add_options(
      *app.add_subcommand("synth", "Synthesise, place and route the chip with its firmware."),
      jobs.synth);
  add_bench(app, jobs.bench);
  add_debug(app, jobs.debug);
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? success : bad_input_of(count, arguments);
  }
  catch_interrupts();
  return do_job(app, jobs, count, arguments);
}

}  // namespace

}  // namespace command

int main(int count, char** arguments) {
  try {
    return command::run_command(count, arguments);
  } catch (const command::Interrupted& wish) {
    command::say_to(stderr, "stepfabric: {}\n", wish.what());
    return command::interrupted;
  } catch (const std::exception& error) {
    std::fflush(stdout);
    command::say_to(stderr, "stepfabric: {}\n", error.what());
    return command::bad_input_of(count, arguments);
  }
}
