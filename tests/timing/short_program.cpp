// SPDX-License-Identifier: Apache-2.0
// Programs from words.
#include "tests/timing/short_program.hpp"

#include "sim/processor/timing_table.hpp"

namespace timing {

namespace encode = processor::encode;
using encode::Word;

Program program_of(const std::vector<Word>& words) {
  Program program;
  program.first = program.memory_start;
  program.memory_bytes = 4096;
  for (const Word word : words) {
    for (int shift = 0; shift < 32; shift += 8) {
      program.bytes.push_back(static_cast<std::uint8_t>(word >> shift));
    }
  }
  program.code_end = program.first + static_cast<Address>(program.bytes.size());
  program.symbols[program.first] = {.name = "all", .size = 4};
  return program;
}

Program with_choices() {
  Program program = program_of({encode::nop(), encode::nop(), encode::branch(0, 10, 0, 8),
                                encode::operation(4, 1, 12, 11, 10), encode::branch(0, 11, 0, 12),
                                encode::load(2, 11, 11, 0), encode::jump_and_link(0, -8),
                                encode::jump_and_link_register(0, 1, 0)});
  program.symbols[program.first + setup_bytes] = {.name = "choices", .size = 4};
  return program;
}

Costs true_costs() { return Costs{processor::TimingTable()}; }

std::optional<Clocks> bound_of(const Program& program, const Costs& costs) {
  return Analysis(program, costs, true).bound(program.first + setup_bytes);
}

}  // namespace timing
