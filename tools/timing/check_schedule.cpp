// SPDX-License-Identifier: Apache-2.0
// check_schedule: refuses an image whose main loop misses a deadline at the clock and baud rate of
// its machine; part of the firmware's build.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>

#include "machine_generator/description.hpp"
#include "sim/processor/timing_table.hpp"
#include "tools/timing/schedule_report.hpp"

namespace {

// Of one clock: the reasons, and what would help. Nothing where it holds.
std::string refusal(const timing::Schedule& schedule, timing::Rate rate) {
  const auto reasons = timing::refusals(schedule, rate);
  std::string text;
  for (const std::string& reason : reasons) text += "  " + reason + "\n";
  if (text.empty() || !schedule.load.is_whole()) return text;
  const auto range = timing::clocks_that_hold(schedule.facts, schedule.load, rate.baud);
  if (range.is_empty()) return text + "remedy: a shorter pass; no clock helps\n";
  return text + fmt::format("remedy: a clock of {} to {} Hz, or a slower serial line\n",
                            range.lowest_hz, range.highest_hz);
}

int check(const std::filesystem::path& image, const std::filesystem::path& file,
          timing::Address memory_bytes, bool has_zbb) {
  const auto machine = machine_generator::read_machine(file);
  const auto& description = machine.description;
  timing::Program program = timing::read_program(image);
  program.memory_bytes = machine.memory_bytes.value_or(memory_bytes);
  const auto schedule = timing::schedule_of(program, timing::Costs{processor::TimingTable()},
                                            has_zbb, application::schedule_facts(description.fast));
  for (const std::string& missing : timing::missing_bounds(schedule)) {
    fmt::print("not checked: {}\n", missing);
  }
  if (!machine.clock_hz) {
    fmt::print("{}: says no clock_mhz, so its schedule is not checked\n", file.string());
    return 0;
  }
  const timing::Rate rate{*machine.clock_hz, description.baud};
  const std::string text = refusal(schedule, rate);
  if (text.empty()) {
    fmt::print("{}: {} at {} Hz and {} baud\n", file.string(),
               schedule.load.is_whole() ? "schedulable" : "nothing known is missed", rate.clock_hz,
               rate.baud);
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
