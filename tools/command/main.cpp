// SPDX-License-Identifier: Apache-2.0
// The `stepfabric` program: one job per call, its exit status.
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "tools/command/bench_job.hpp"
#include "tools/command/build.hpp"
#include "tools/command/debug_job.hpp"
#include "tools/command/exit_status.hpp"
#include "tools/command/fuzz_job.hpp"
#include "tools/command/load_job.hpp"
#include "tools/command/output.hpp"
#include "tools/command/plan_job.hpp"
#include "tools/command/print_job.hpp"
#include "tools/command/printer_setup.hpp"
#include "tools/command/run_job.hpp"
#include "tools/command/serve_job.hpp"
#include "tools/command/signals.hpp"
#include "tools/command/spool_job.hpp"
#include "tools/command/test_job.hpp"
#include "tools/command/timing_job.hpp"
#include "tools/figures/job.hpp"
#include "tools/process/process.hpp"
#include "tools/proof/run.hpp"
#include "tools/synthesis/job.hpp"

namespace command {

namespace {

struct Jobs {
  PrintOptions print;
  PlanOptions plan;
  ServeOptions serve;
  SpoolOptions spool;
  RunOptions run;
  LoadOptions load;
  proof::Options prove;
  synthesis::Options synth;
  BenchOptions bench;
  DebugOptions debug;
  FuzzOptions fuzz;
  figures::Options figures;
  TestOptions test;
  TimingOptions timing;
};

// Waveforms and the debug port need other builds of the chip's model, so that they do not slow down
// the default one.
[[noreturn]] void become_other_program(const std::string& name, const char* model, int count,
                                       char** arguments) {
  fmt::print(stderr, "stepfabric: building the model that {}\n", model);
  build({name});
  std::vector<std::string> words{(build_folder() / "bin" / name).string()};
  words.insert(words.end(), arguments + 1, arguments + count);
  process::become(words);
}

bool this_is_program(const char* path, std::string_view name) {
  return std::string_view(path).ends_with(name);
}

// Of this call: another one may build another machine's meanwhile.
class FirmwareOfCall {
 public:
  FirmwareOfCall() = default;
  FirmwareOfCall(const FirmwareOfCall&) = delete;
  FirmwareOfCall& operator=(const FirmwareOfCall&) = delete;
  ~FirmwareOfCall() {
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
  }

  const std::filesystem::path file =
      build_folder() / "boards" / fmt::format("firmware_{}.elf", getpid());
};

int synthesize(synthesis::Options options) {
  const auto of_build = build_folder() / "firmware" / "firmware.elf";
  const FirmwareOfCall of_machine;
  if (!options.machine.empty()) {
    options.memory_bytes = write_board_firmware(options.machine, of_machine.file);
  }
  if (options.machine.empty()) build({"firmware"});
  const auto& firmware = options.machine.empty() ? of_build : of_machine.file;
  return synthesis::synthesize(options, project_folder(), firmware, end_if_interrupted) ? success
                                                                                        : failure;
}

int do_job(const CLI::App& app, const Jobs& jobs, int count, char** arguments) {
  const bool traces = !jobs.print.trace.empty() || !jobs.run.trace.empty();
  if (traces && !this_is_program(arguments[0], "stepfabric_traced")) {
    become_other_program("stepfabric_traced", "writes waveforms, with the processor by its netlist",
                         count, arguments);
  }
  for (const PrinterChoices* choices : {&jobs.print.printer, &jobs.serve.printer}) {
    if (jobs.print.board.empty() && !traces && has_two_extruders(*choices) &&
        !this_is_program(arguments[0], "stepfabric_two_tools")) {
      become_other_program("stepfabric_two_tools", "has three heaters", count, arguments);
    }
  }
  if (const std::string& board = jobs.print.board; !board.empty()) {
    const std::string name = "stepfabric_" + board;
    if (!this_is_program(arguments[0], name)) {
      become_other_program(name, "has the board's top entity around it", count, arguments);
    }
  }
  if (app.got_subcommand("debug")) {
    if (!this_is_program(arguments[0], "stepfabric_debug")) {
      become_other_program("stepfabric_debug",
                           "has the debug port, with the processor by its netlist", count,
                           arguments);
    }
    return debug(jobs.debug);
  }
  if (app.got_subcommand("print")) return print(jobs.print);
  if (app.got_subcommand("plan")) return plan(jobs.plan);
  if (app.got_subcommand("serve")) return serve(jobs.serve);
  if (app.got_subcommand("spool")) return spool(jobs.spool);
  if (app.got_subcommand("run")) return run(jobs.run);
  if (app.got_subcommand("load")) return load(jobs.load);
  if (app.got_subcommand("bench")) return bench(jobs.bench);
  if (app.got_subcommand("fuzz")) return fuzz(jobs.fuzz);
  if (app.got_subcommand("test")) return test(jobs.test);
  if (app.got_subcommand("timing")) return timing_of(jobs.timing);
  if (app.got_subcommand("figures")) {
    const bool good =
        figures::run(jobs.figures, project_folder(), build_folder(), build, end_if_interrupted);
    return good ? success : failure;
  }
  if (app.got_subcommand("prove")) {
    return proof::prove(jobs.prove, project_folder(), build_folder()) ? success : failure;
  }
  return synthesize(jobs.synth);
}

// A file opened while one of these is closed would get its descriptor, and messages to the stream
// would be written into that file.
void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // Reading from the second and third of them fails, as writing to the first does.
    const int flags = stream == STDIN_FILENO ? O_WRONLY : O_RDONLY;
    if (fcntl(stream, F_GETFD) < 0 && open("/dev/null", flags) != stream) std::_Exit(bad_input);
  }
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
  add_options(app, jobs.print);
  add_options(app, jobs.plan);
  add_options(app, jobs.serve);
  add_options(app, jobs.spool);
  add_options(app, jobs.run);
  add_options(app, jobs.load);
  auto* tests =
      app.add_subcommand("test", "Build everything and run all tests, or those of some labels.");
  tests->add_option("labels", jobs.test.labels, "unit, testbench, repository, scenario, fuzz, ...")
      ->type_name("LABEL...");
  tests
      ->add_option("--costs", jobs.test.costs,
                   "run no test: write what each took in the last run into this folder")
      ->type_name("DIR");
  add_options(app, jobs.fuzz);
  proof::add_options(*app.add_subcommand(
                         "prove", "Run the formal proofs, and check each against injected faults."),
                     jobs.prove);
  synthesis::add_options(
      *app.add_subcommand("synth", "Synthesise, place and route the chip with its firmware."),
      jobs.synth);
  add_options(app, jobs.bench);
  figures::add_options(
      *app.add_subcommand("figures", "Measure the figures that the pages show, and write them."),
      jobs.figures);
  add_options(app, jobs.debug);
  add_options(app, jobs.timing);
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
  command::open_standard_streams();
  try {
    return command::run_command(count, arguments);
  } catch (const command::Interrupted& error) {
    command::say_to(stderr, "stepfabric: {}\n", error.what());
    return command::interrupted;
  } catch (const std::exception& error) {
    std::fflush(stdout);
    command::say_to(stderr, "stepfabric: {}\n", error.what());
    return command::bad_input_of(count, arguments);
  }
}
