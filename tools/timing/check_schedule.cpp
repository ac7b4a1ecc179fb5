// SPDX-License-Identifier: Apache-2.0
// check_schedule: refuses an image whose main loop has no bound, or misses a deadline at the clock
// and baud rate of its machine; part of the firmware's build.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>

#include "machine_generator/description.hpp"
#include "sim/processor/timing_table.hpp"
#include "tools/timing/machine_schedule.hpp"

namespace {

int check(const std::filesystem::path& image, const std::filesystem::path& file,
          timing::Address memory_bytes, bool has_zbb) {
  const auto read = machine_generator::read_machine(file);
  const auto machine = read.whole();
  timing::Program program = timing::read_program(image);
  program.memory_bytes = read.memory_bytes.value_or(memory_bytes);
  const auto schedule =
      timing::schedule_of(program, timing::Costs{processor::TimingTable()}, has_zbb,
                          application::schedule_facts(machine.fast, machine.is_heavy()));
  const timing::Verdict verdict =
      timing::verdict_on(schedule, machine, read.clock_hz, file.string());
  fmt::print(verdict.is_refused ? stderr : stdout, "{}", verdict.text);
  return verdict.is_refused ? 1 : 0;
}

}  // namespace

int main(int count, char** arguments) {
  CLI::App app("Refuses an image that misses a deadline at its machine's clock.", "check_schedule");
  std::filesystem::path image, machine;
  timing::Address memory_bytes = CHIP_MEMORY_BYTES;
  bool has_zbb = false;
  app.add_option("image", image, "The image")->required()->check(CLI::ExistingFile);
  app.add_option("machine", machine, "Its machine description")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_flag("--zbb", has_zbb, "The image is compiled for Zbb");
  CLI11_PARSE(app, count, arguments);
  try {
    return check(image, machine, memory_bytes, has_zbb);
  } catch (const std::exception& error) {
    fmt::print(stderr, "check_schedule: {}\n", error.what());
    return 2;
  }
}
