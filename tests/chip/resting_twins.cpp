// SPDX-License-Identifier: Apache-2.0
// The states inside the two models must be equal as well.
#include "tests/chip/resting_twins.hpp"

#include <fmt/format.h>

namespace tests {

namespace {

constexpr std::uint32_t memory_start = 0x8000'0000;

}  // namespace

RestingTwins::RestingTwins(std::uint32_t clock_hz)
    : Twins(all_edges_, needed_edges_),
      all_edges_(clock_hz, sim::Edges::all),
      needed_edges_(clock_hz, sim::Edges::leaping) {
  compare();
}

void RestingTwins::write_memory(std::uint32_t address, std::uint32_t word) {
  all_edges_.write_memory(address, word);
  needed_edges_.write_memory(address, word);
}

void RestingTwins::compare_inside() const {
  for (std::uint32_t address = memory_start; address < memory_start + CHIP_MEMORY_BYTES;
       address += 4) {
    if (all_edges_.read_memory(address) != needed_edges_.read_memory(address)) {
      throw TwinsDiffer(fmt::format("the memories differ at {:#x}", address));
    }
  }
  const sim::ProcessorStatistics expected = all_edges_.processor_statistics();
  const sim::ProcessorStatistics processor = needed_edges_.processor_statistics();
  if (processor.instructions != expected.instructions ||
      processor.sleeping_clocks != expected.sleeping_clocks) {
    throw TwinsDiffer(fmt::format(
        "{} instructions instead of {}, asleep for {} clocks instead of {}", processor.instructions,
        expected.instructions, processor.sleeping_clocks, expected.sleeping_clocks));
  }
  const sim::QueueStatistics queue = needed_edges_.queue_statistics();
  const sim::QueueStatistics expected_queue = all_edges_.queue_statistics();
  if (queue.underruns != expected_queue.underruns ||
      queue.guard_stall_clocks != expected_queue.guard_stall_clocks ||
      queue.depth != expected_queue.depth || queue.max_depth != expected_queue.max_depth) {
    throw TwinsDiffer("the counters of the step generator differ");
  }
}

}  // namespace tests
