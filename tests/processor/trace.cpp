// SPDX-License-Identifier: Apache-2.0
// Writes a line for each instruction that the netlist completes or refuses, with its clock, as
// testbench/processor/processor_trace.vhd does. Usage: processor_trace PROGRAM OUTPUT
#include <cstdio>
#include <exception>
#include <memory>
#include <stdexcept>

#include "tests/processor/chip.hpp"
#include "tests/processor/program.hpp"

namespace processor {
namespace {

constexpr std::uint64_t most_clocks = 2'000'000;
constexpr std::uint64_t clocks_behind_the_end = 10;
// The program sleeps with this word in the device's first until it is woken.
constexpr std::uint32_t wake_word = 0x51ee9;
constexpr std::uint32_t wake_request = 1u << 20;
constexpr unsigned wake_after_clocks = 50;

void print(std::FILE* file, std::uint64_t clock, const Retirement& retirement) {
  std::fprintf(file, "%llu %d%d%d %08X", static_cast<unsigned long long>(clock), !retirement.trap,
               retirement.trap, retirement.interrupt, retirement.address);
  if (!retirement.trap) std::fprintf(file, " %08X", retirement.instruction);
  if (!retirement.trap && retirement.destination != 0) {
    std::fprintf(file, " x%u %08X", retirement.destination, retirement.value);
  }
  std::fputc('\n', file);
}

void write_trace(const std::string& name, const char* output) {
  const Program program = read_program(name);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(output, "w"), std::fclose);
  if (!file) throw std::runtime_error(std::string("cannot write ") + output);
  Chip chip(program.image);
  const std::uint64_t start = chip.clocks();
  const std::uint32_t tohost = program.symbols.at("tohost");
  unsigned asleep = 0;
  std::uint64_t end = start + most_clocks;
  while (chip.clocks() < end) {
    const auto retirement = chip.clock();
    if (retirement) print(file.get(), chip.clocks() - start, *retirement);
    asleep = chip.sleeping() ? asleep + 1 : 0;
    if (asleep == wake_after_clocks && chip.device().read(TestDevice::base) == wake_word) {
      chip.device().set_interrupts(chip.device().interrupts() | wake_request);
    }
    if (end == start + most_clocks && chip.word(tohost) != 0) {
      end = chip.clocks() + clocks_behind_the_end;
    }
  }
}

}  // namespace
}  // namespace processor

int main(int count, char** arguments) {
  try {
    if (count != 3) throw std::runtime_error("usage: processor_trace PROGRAM OUTPUT");
    processor::write_trace(arguments[1], arguments[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "processor_trace: %s\n", error.what());
    return 2;
  }
}
