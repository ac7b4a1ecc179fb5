// SPDX-License-Identifier: Apache-2.0
// Programs of instructions to try, with a handler that goes on after each that traps.
#include "tests/processor/trial.hpp"

#include <algorithm>
#include <stdexcept>

#include "tests/processor/chip.hpp"
#include "tests/processor/program_builder.hpp"

namespace processor {
namespace {

using encode::Word;

constexpr Word cause = 18, address = 19, value = 20, next = 21, length = 22, pointer = 5;
constexpr Word base_address = 0x8000F000, bytes_on_either_side = 0x800;
// The start-up has as many instructions as lie before the handler.
constexpr Word handler_address = Chip::memory_base + 0x20;

Word csr_read(Word destination, Word number) { return encode::csr(2, destination, number, 0); }

void add_start_up(ProgramBuilder& program, unsigned bytes) {
  program.add(encode::add_upper_to_pc(pointer, 0));
  program.add(encode::add_immediate(pointer, pointer, handler_address - Chip::memory_base));
  program.add(encode::csr(1, 0, 0x305, pointer));
  program.add(encode::add_immediate(length, 0, static_cast<std::int32_t>(bytes)));
  program.add(encode::load_upper(trial::base, base_address));
  program.add(encode::add_immediate(trial::ones, 0, -1));
  constexpr int instructions_of_the_handler = 6;
  program.add(encode::jump_and_link(0, 4 * (2 + instructions_of_the_handler)));
  program.add(encode::nop());
}

void add_handler(ProgramBuilder& program) {
  program.add(csr_read(cause, 0x342));
  program.add(csr_read(address, 0x341));
  program.add(csr_read(value, 0x343));
  program.add(encode::operation(0, 0, next, address, length));
  program.add(encode::csr(1, 0, 0x341, next));
  program.add(encode::trap_return());
}

// What the handler reads, from the trace of the chip.
void note(TrapFindings& findings, const Retirement& event) {
  switch (event.destination) {
    case cause:
      findings.cause = event.value;
      break;
    case address:
      findings.address = event.value;
      break;
    case value:
      findings.value = event.value;
      break;
    default:
      break;
  }
}

std::vector<Outcome> run(const std::vector<Word>& instructions, unsigned bytes) {
  ProgramBuilder program;
  add_start_up(program, bytes);
  add_handler(program);
  const std::uint32_t first = Chip::memory_base + program.bytes();
  for (const Word instruction : instructions) {
    bytes == 2 ? program.add_short(instruction) : program.add_long(instruction);
  }
  const std::uint32_t end = Chip::memory_base + program.bytes();
  program.add(encode::jump_and_link(0, 0));

  Chip chip(program.image());
  std::vector<Outcome> outcomes;
  while (auto event = chip.next_retirement()) {
    if (event->address >= end) break;
    if (event->address < first) {
      if (!outcomes.empty()) note(*outcomes.back().trap, *event);
      continue;
    }
    const std::size_t index = outcomes.size();
    const std::uint32_t expected = first + bytes * static_cast<std::uint32_t>(index);
    if (index >= instructions.size() || event->address != expected) break;
    outcomes.push_back({instructions[index], event->address, std::nullopt, event->value});
    if (event->trap) outcomes.back().trap.emplace();
  }
  if (outcomes.size() != instructions.size()) {
    throw std::runtime_error("the chip left the instructions that are tried behind the " +
                             std::to_string(outcomes.size()) + "th");
  }
  return outcomes;
}

}  // namespace

std::vector<Outcome> try_instructions(const std::vector<Word>& instructions, unsigned bytes) {
  constexpr std::uint32_t room = base_address - bytes_on_either_side - handler_address - 0x40;
  std::vector<Outcome> outcomes;
  for (std::size_t begin = 0; begin < instructions.size(); begin += room / bytes) {
    const std::size_t end = std::min<std::size_t>(begin + room / bytes, instructions.size());
    const auto some = run({instructions.begin() + static_cast<std::ptrdiff_t>(begin),
                           instructions.begin() + static_cast<std::ptrdiff_t>(end)},
                          bytes);
    outcomes.insert(outcomes.end(), some.begin(), some.end());
  }
  return outcomes;
}

}  // namespace processor
