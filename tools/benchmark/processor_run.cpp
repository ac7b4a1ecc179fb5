// SPDX-License-Identifier: Apache-2.0
// Writes the workload into memory, clocks the processor, and records what retires between
// the marks.
#include "tools/benchmark/processor_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "tests/processor/chip.hpp"

namespace benchmarks {

namespace {

using benchmark::ProcessorOrder;
using processor::Chip;

constexpr std::uint64_t most_clocks = 400'000'000;

std::uint32_t address_of(const sim::ElfImage& program, const char* symbol) {
  const auto address = program.symbol(symbol);
  if (!address) throw std::runtime_error(fmt::format("the program has no symbol {}", symbol));
  return *address;
}

std::vector<std::uint8_t> memory_of(const sim::ElfImage& program) {
  std::vector<std::uint8_t> memory(Chip::memory_size);
  for (const sim::ElfSegment& segment : program.segments) {
    const std::size_t begin = segment.address - Chip::memory_base;
    if (begin + segment.bytes.size() > memory.size()) {
      throw std::runtime_error("the program is larger than the processor's memory");
    }
    std::ranges::copy(segment.bytes, memory.begin() + static_cast<std::ptrdiff_t>(begin));
  }
  return memory;
}

void put_word(std::vector<std::uint8_t>& memory, std::size_t place, std::uint32_t word) {
  for (unsigned i = 0; i < 4; ++i) memory.at(place + i) = static_cast<std::uint8_t>(word >> 8 * i);
}

}  // namespace

WorkRun run_work(const sim::ElfImage& program, std::uint32_t iterations, const std::string& text) {
  if (text.size() > ProcessorOrder::most_text_bytes) {
    throw std::runtime_error("the text is larger than the program's room for it");
  }
  auto memory = memory_of(program);
  const std::size_t order = address_of(program, "benchmark_order") - Chip::memory_base;
  put_word(memory, order, iterations);
  put_word(memory, order + 4, static_cast<std::uint32_t>(text.size()));
  std::ranges::copy(text, memory.begin() + static_cast<std::ptrdiff_t>(order + 8));

  const std::uint32_t begin = address_of(program, "benchmark_begin");
  const std::uint32_t end = address_of(program, "benchmark_end");
  const std::uint32_t result = address_of(program, "benchmark_result");
  Chip chip(memory);
  WorkRun run;
  bool measuring = false;
  while (chip.clocks() < most_clocks) {
    const auto event = chip.clock();
    if (!event) continue;
    if (event->trap) {
      throw std::runtime_error(fmt::format("the program trapped at {:#010x}, instruction {:#x}",
                                           event->address, event->instruction));
    }
    if (event->address == end) {
      run.result = {.units = chip.word(result), .checksum = chip.word(result + 4)};
      return run;
    }
    if (measuring) run.use.add(event->address, event->instruction, event->clock);
    measuring = measuring || event->address == begin;
  }
  throw std::runtime_error(fmt::format("the program did not end within {} clocks", most_clocks));
}

}  // namespace benchmarks
