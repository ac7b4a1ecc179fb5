// SPDX-License-Identifier: Apache-2.0
// CSRs as software reads them.
#include "sim/replay/processor_snapshot.hpp"

#include <algorithm>

namespace replay {

ProcessorSnapshot snapshot_of(const processor::MachineState& state, sim::Clock now) {
  ProcessorSnapshot snapshot;
  std::copy_n(state.registers.begin(), snapshot.registers.size(), snapshot.registers.begin());
  snapshot.registers[0] = 0;
  snapshot.program_counter = state.program_counter;
  snapshot.mstatus = (state.interrupt_enable ? 1U << 3 : 0) |
                     (state.previous_interrupt_enable ? 1U << 7 : 0) | 3U << 11;
  snapshot.mie = state.interrupts_enabled;
  snapshot.mtvec = state.trap_vector;
  snapshot.mscratch = state.scratch;
  snapshot.mepc = state.exception_address;
  snapshot.mcause = state.trap_cause;
  snapshot.mtval = state.trap_value;
  snapshot.mcountinhibit = (state.cycles.stopped ? 1U : 0) | (state.retired.stopped ? 4U : 0);
  snapshot.mcycle = state.cycles.at(now + 1);
  snapshot.minstret = state.retired.at(state.instructions);
  return snapshot;
}

std::vector<std::pair<std::string, std::uint64_t>> named_values(const ProcessorSnapshot& snapshot) {
  std::vector<std::pair<std::string, std::uint64_t>> values{
      {"pc", snapshot.program_counter},
      {"mstatus", snapshot.mstatus},
      {"mie", snapshot.mie},
      {"mtvec", snapshot.mtvec},
      {"mscratch", snapshot.mscratch},
      {"mepc", snapshot.mepc},
      {"mcause", snapshot.mcause},
      {"mtval", snapshot.mtval},
      {"mcountinhibit", snapshot.mcountinhibit},
      {"mcycle", snapshot.mcycle},
      {"minstret", snapshot.minstret}};
  for (std::size_t i = 1; i < snapshot.registers.size(); ++i) {
    values.emplace_back("x" + std::to_string(i), snapshot.registers[i]);
  }
  return values;
}

}  // namespace replay
