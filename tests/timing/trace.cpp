// SPDX-License-Identifier: Apache-2.0
// The processor model, one clock after the other.
#include "tests/timing/trace.hpp"

#include "sim/processor/encode.hpp"
#include "sim/processor/processor_model.hpp"

namespace timing {

std::vector<Step> trace(const Program& program, Address stop, std::uint64_t clocks,
                        std::uint32_t word) {
  processor::ProcessorModel model(program.memory_bytes, true);
  for (std::size_t place = 0; place < program.bytes.size(); place += 4) {
    const auto address = program.first + static_cast<Address>(place);
    model.write_memory(address, program.word_at(address));
  }
  // What lies before this is the way to the boot loader, which is not here.
  if (const auto start = program.addresses.find("_start"); start != program.addresses.end()) {
    model.write_memory(program.first,
                       processor::encode::jump_and_link(
                           0, static_cast<std::int32_t>(start->second - program.first)));
  }
  model.reset(1);
  std::vector<Step> steps{
      {.address = model.state().program_counter, .begins = model.state().begins}};
  for (std::uint64_t clock = 1; clock < clocks; ++clock) {
    model.mark();
    model.run(clock);
    if (model.accesses() && model.access_clock() + 2 == clock) {
      model.complete_access(clock, false, word);
      steps.back().on_bus = true;
    }
    const processor::MachineState& state = model.state();
    if (state.instructions == steps.size() - 1) continue;
    if (state.instructions != steps.size() || state.traps != 0) break;
    steps.push_back({.address = state.program_counter, .begins = state.begins});
    if (state.program_counter == stop) break;
  }
  if (program.addresses.contains("_start")) steps.erase(steps.begin());
  return steps;
}

std::uint64_t sum_of_costs(const Program& program, const Costs& costs,
                           const std::vector<Step>& steps) {
  std::uint64_t sum = 0;
  const auto at = [&](std::size_t i) {
    return processor::decode(program.word_at(steps[i].address), steps[i].address, true);
  };
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
    const auto instruction = at(i);
    const bool taken = steps[i + 1].address != steps[i].address + instruction.bytes;
    sum += costs.of(instruction, taken, steps[i].on_bus);
    // The last one may still wait for a late result.
    if (i + 2 < steps.size()) sum += costs.between(instruction, at(i + 1));
  }
  return sum;
}

}  // namespace timing
