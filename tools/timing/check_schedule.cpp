// SPDX-License-Identifier: Apache-2.0
// check_schedule: refuses an image whose main loop misses a deadline at the clock and baud rate of
// its machine; part of the firmware's build.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>

#include "machine_generator/description.hpp"
#include "sim/processor/timing_table.hpp"
#include "tools/timing/machine_schedule.hpp"

namespace {

// At any clock, where the description names none.
int check_all_clocks(const timing::Schedule& schedule, const std::string& machine,
                     std::uint32_t baud) {
  const auto range = timing::clocks_that_hold(schedule.facts, schedule.load, baud);
  if (range.is_empty()) {
    fmt::print(stderr, "{}: not schedulable at {} baud:\n  {}\nremedy: a shorter pass{}\n", machine,
               baud, timing::to_text(range),
               range.slower_fails == timing::Requirement::bits ? ", or a slower serial line" : "");
    return 1;
  }
  fmt::print("{}: schedulable at {} to {} Hz and {} baud\n", machine, range.lowest_hz,
             range.highest_hz, baud);
  return 0;
}

int check(const std::filesystem::path& image, const std::filesystem::path& file,
          timing::Address memory_bytes, bool has_zbb) {
  const auto read = machine_generator::read_machine(file);
  const auto machine = read.whole();
  timing::Program program = timing::read_program(image);
  program.memory_bytes = read.memory_bytes.value_or(memory_bytes);
  const auto schedule =
      timing::schedule_of(program, timing::Costs{processor::TimingTable()}, has_zbb,
                          application::schedule_facts(machine.fast, machine.is_heavy()));
  const auto missing = timing::missing_bounds(schedule);
  for (const std::string& each : missing) fmt::print("not checked: {}\n", each);
  const auto left_out = timing::left_out(machine);
  for (const timing::Requirement each : left_out.requirements) {
    fmt::print("not checked: {}: {}\n", timing::row_of(each).name, left_out.reason);
  }
  const bool is_proved = missing.empty() && left_out.requirements.empty();
  if (!read.clock_hz) {
    if (is_proved) return check_all_clocks(schedule, file.string(), machine.baud);
    fmt::print("{}: says no clock_mhz, so its schedule is not checked\n", file.string());
    return 0;
  }
  const timing::Rate rate{*read.clock_hz, machine.baud};
  const std::string text = timing::refusal_of(schedule, machine, rate);
  if (text.empty()) {
    fmt::print("{}: {} at {} Hz and {} baud\n", file.string(),
               is_proved ? "schedulable" : "nothing known is missed", rate.clock_hz, rate.baud);
    return 0;
  }
  fmt::print(stderr, "{}: not schedulable at {} Hz and {} baud:\n{}", file.string(), rate.clock_hz,
             rate.baud, text);
  return 1;
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
