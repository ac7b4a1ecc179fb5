// SPDX-License-Identifier: Apache-2.0
// Keeps both models at one time with the same inputs, and compares them.
#include "tests/chip/twin_chip.hpp"

#include <fmt/format.h>

namespace tests {

namespace {

constexpr std::uint32_t memory_start = 0x8000'0000, memory_bytes = 65536;

}  // namespace

TwinChip::TwinChip(std::uint32_t clock_hz)
    : reference_(clock_hz, sim::Edges::all), tested_(clock_hz, sim::Edges::needed) {
  take_over();
}

void TwinChip::take_over() {
  now_ = reference_.now();
  outputs_ = reference_.outputs();
  if (tested_.now() != now_ || tested_.outputs() != outputs_) {
    throw TwinsDiffer(fmt::format(
        "with all edges the pins are {:#x} at clock {}, with the needed ones {:#x} at {}",
        outputs_.word, now_, tested_.outputs().word, tested_.now()));
  }
}

void TwinChip::advance(sim::Clock limit) {
  reference_.inputs() = inputs_;
  tested_.inputs() = inputs_;
  reference_.advance(limit);
  // Returns earlier where its pins change earlier.
  tested_.advance(reference_.now());
  take_over();
}

void TwinChip::reset() {
  reference_.reset();
  tested_.reset();
  take_over();
}

std::uint32_t TwinChip::read_memory(std::uint32_t address) const {
  return tested_.read_memory(address);
}

void TwinChip::write_memory(std::uint32_t address, std::uint32_t word) {
  reference_.write_memory(address, word);
  tested_.write_memory(address, word);
}

void TwinChip::compare_inside() const {
  for (std::uint32_t address = memory_start; address < memory_start + memory_bytes; address += 4) {
    if (reference_.read_memory(address) != tested_.read_memory(address)) {
      throw TwinsDiffer(fmt::format("the memories differ at {:#x}", address));
    }
  }
  const sim::ProcessorStatistics expected = reference_.processor_statistics();
  const sim::ProcessorStatistics processor = tested_.processor_statistics();
  if (processor.instructions != expected.instructions ||
      processor.sleeping_clocks != expected.sleeping_clocks) {
    throw TwinsDiffer(fmt::format(
        "{} instructions instead of {}, asleep for {} clocks instead of {}", processor.instructions,
        expected.instructions, processor.sleeping_clocks, expected.sleeping_clocks));
  }
  const sim::QueueStatistics queue = tested_.queue_statistics();
  const sim::QueueStatistics expected_queue = reference_.queue_statistics();
  if (queue.underruns != expected_queue.underruns ||
      queue.guard_stall_clocks != expected_queue.guard_stall_clocks ||
      queue.depth != expected_queue.depth || queue.max_depth != expected_queue.max_depth) {
    throw TwinsDiffer("the counters of the step generator differ");
  }
}

}  // namespace tests
