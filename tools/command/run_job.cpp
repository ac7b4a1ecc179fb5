// SPDX-License-Identifier: Apache-2.0
// The riscv-tests convention: the program ends by a store of a value other than 0 to `tohost`.
#include "tools/command/run_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <string_view>

#include "sim/devices/serial_line.hpp"
#include "sim/simulation/elf_image.hpp"
#include "sim/simulation/simulation.hpp"
#include "sim/simulation/verilated_chip.hpp"
#include "tools/command/exit_status.hpp"
#include "tools/command/file_roles.hpp"
#include "tools/command/output.hpp"
#include "tools/command/signals.hpp"
#include "tools/command/signature.hpp"

namespace command {

namespace {

constexpr std::uint32_t reset_address = 0x8000'0000;
constexpr sim::Clock clocks_between_looks_at_the_keyboard = 100'000;

class PrintedBytes : public devices::ByteListener {
 public:
  void byte_received(sim::Clock, std::uint8_t byte) override { std::putchar(byte); }
};

// The chip's memory is read by words.
void check_place(std::uint32_t tohost, const sim::Chip& chip) {
  if (tohost % 4 != 0) {
    throw std::runtime_error(
        fmt::format("`tohost` lies at {:#010x}: align it to a multiple of 4 bytes", tohost));
  }
  try {
    chip.read_memory(tohost);
  } catch (const std::out_of_range&) {
    throw std::runtime_error(
        fmt::format("`tohost` lies at {:#010x}, where the chip has no memory", tohost));
  }
}

// 0 where the program passed; never 0 otherwise.
std::uint32_t status_of(std::uint32_t value) {
  return value == 1 ? 0 : std::max<std::uint32_t>(1, value >> 1);
}

int say_how_it_ended(std::uint32_t value) {
  const std::uint32_t status = status_of(value);
  if (status == 0) {
    say("passed: tohost = {}\n", value);
    return success;
  }
  constexpr std::uint32_t highest = highest_program_status;
  say("failed: tohost = {}, status {}{}\n", value, status,
      status > highest ? fmt::format(", which the exit status says as {}", highest) : "");
  return static_cast<int>(std::min(status, highest));
}

// Clocks until `tohost` is written; 0 where it was not within `max_cycles`.
std::uint32_t wait_for_store(sim::Simulation& simulation, std::uint32_t tohost,
                             std::uint64_t max_cycles) {
  while (simulation.now() < max_cycles) {
    simulation.run_until(simulation.now() + 1);
    const std::uint32_t value = simulation.chip().read_memory(tohost);
    if (value != 0) return value;
    if (simulation.now() % clocks_between_looks_at_the_keyboard == 0 && interrupt_requested()) {
      break;
    }
  }
  return 0;
}

// Why a program may not have ended, from the present state of the processor.
std::string_view what_goes_on(sim::Simulation& simulation) {
  constexpr sim::Clock clocks_to_watch = 1'000;
  const sim::ProcessorStatistics before = simulation.chip().processor_statistics();
  simulation.run_until(simulation.now() + clocks_to_watch);
  const sim::ProcessorStatistics after = simulation.chip().processor_statistics();
  if (after.instructions != before.instructions) {
    return "it still runs, and --max-cycles grants it more";
  }
  if (after.sleeping_clocks == before.sleeping_clocks + clocks_to_watch) {
    return "it sleeps, and no interrupt comes that would wake it";
  }
  return "it completes no instruction any more; does mtvec point to a trap handler?";
}

}  // namespace

void make_start(const sim::ElfImage& image, sim::Chip& chip) {
  if (image.entry == reset_address) return;
  constexpr std::uint32_t jump_bytes = 8;
  const bool free = std::ranges::all_of(image.segments, [](const sim::ElfSegment& segment) {
    return segment.address >= reset_address + jump_bytes;
  });
  if (!free) {
    throw std::runtime_error(fmt::format(
        "the program begins at {:#010x}, but the chip starts at {:#010x}, where other code lies: "
        "put the entry at the beginning of the memory",
        image.entry, reset_address));
  }
  const std::uint32_t upper = (image.entry + 0x800) & 0xffff'f000;
  const std::uint32_t lower = (image.entry - upper) & 0xfff;
  chip.write_memory(reset_address, upper | 0x2b7);  // lui t0, upper
  chip.write_memory(reset_address + 4, lower << 20 | 0x28067);  // jalr zero, lower(t0)
}

int run(const RunOptions& options) {
  let_writes_fail();
  const std::array<NamedFile, 1> read{{{"the program", options.program}}};
  const std::array<NamedFile, 2> written{
      {{"--signature", options.signature}, {"--trace", options.trace}}};
  check_that_files_differ(read, written);
  const sim::ElfImage image = sim::read_elf(options.program);
  const std::optional<std::uint32_t> tohost = image.symbol("tohost");
  if (!tohost) {
    say_to(stderr,
           "{} has no symbol `tohost`{}: a program must define this word, and end by a store of 1 "
           "(passed) or 2 * status + 1 to it\n",
           options.program.string(),
           image.symbols.empty() ? ", as it has no symbols at all (is it stripped?)" : "");
    return not_run;
  }
  sim::VerilatedChip chip(options.clock_hz);
  load(image, chip);
  make_start(image, chip);
  check_place(*tohost, chip);
  std::optional<Signature> signature;
  if (!options.signature.empty()) signature = find_signature(image, chip);
  if (!options.trace.empty()) chip.trace_to(options.trace);
  const sim::ClockRate rate(options.clock_hz);
  sim::Simulation simulation(chip, rate);
  PrintedBytes printed;
  std::optional<devices::SerialLine> line;
  if (options.baud) {
    line.emplace(rate, *options.baud, chip.inputs());
    line->set_listener(printed);
    simulation.attach(*line, sim::OutputPins::transmit_pin());
  }

  const auto started = std::chrono::steady_clock::now();
  const std::uint32_t value = wait_for_store(simulation, *tohost, options.max_cycles);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - started;
  std::fflush(stdout);
  say("cycles {}\ninstructions {}\n", chip.now(), chip.processor_statistics().instructions);
  say_to(stderr, "{:.2f} million clocks per second\n",
         static_cast<double>(chip.now()) / std::max(wall.count(), 1e-9) * 1e-6);
  if (value != 0) {
    if (signature) write_signature(*signature, chip, options.signature);
    return say_how_it_ended(value);
  }
  if (interrupt_requested()) return interrupted;
  say_to(stderr, "{} did not store to tohost within {} cycles: {}\n", options.program.string(),
         options.max_cycles, what_goes_on(simulation));
  return time_out;
}

}  // namespace command
