// SPDX-License-Identifier: Apache-2.0
// Attributes the extra clocks of an instruction to a cause, by the instruction and its neighbours.
#include "tools/benchmark/clock_use.hpp"

#include <algorithm>

#include "tests/processor/instruction_set_model.hpp"

namespace benchmarks {

namespace {

// Of the lowest 7 bits ("RISC-V Instruction Set Manual", volume I, table of opcodes).
enum Opcode : std::uint32_t {
  load = 0x03,
  miscellaneous = 0x0F,
  operation_immediate = 0x13,
  upper_to_pc = 0x17,
  store = 0x23,
  operation = 0x33,
  upper = 0x37,
  branch = 0x63,
  jump_register = 0x67,
  jump = 0x6F,
  system = 0x73
};

constexpr std::uint32_t opcode_of(std::uint32_t word) { return word & 0x7F; }
constexpr std::uint32_t funct3_of(std::uint32_t word) { return word >> 12 & 7; }

bool multiplies_or_divides(std::uint32_t word) {
  return opcode_of(word) == operation && word >> 25 == 1;
}
bool divides(std::uint32_t word) { return multiplies_or_divides(word) && funct3_of(word) >= 4; }
bool multiplies(std::uint32_t word) { return multiplies_or_divides(word) && funct3_of(word) < 4; }

// Of Zbb what has a late result: neither a rotation nor logic.
bool manipulates_bits(std::uint32_t word) {
  const std::uint32_t code = word >> 25;
  const bool rotates = code == 0x30 && (funct3_of(word) == 5 || opcode_of(word) == operation);
  return processor::bit_manipulation(word, 0, 0).has_value() && !rotates && code != 0x20;
}
// An instruction that reads its result next stalls for a clock.
bool is_late(std::uint32_t word) {
  const bool reads_csr = opcode_of(word) == system && funct3_of(word) != 0;
  return opcode_of(word) == load || multiplies(word) || manipulates_bits(word) || reads_csr;
}

bool has_destination(std::uint32_t word) {
  const auto opcode = opcode_of(word);
  return opcode != store && opcode != branch && opcode != miscellaneous;
}

std::uint32_t first_source(std::uint32_t word) {
  const auto opcode = opcode_of(word);
  const bool constant = opcode == upper || opcode == upper_to_pc || opcode == jump ||
                        (opcode == system && funct3_of(word) >= 4);
  return constant ? 0 : word >> 15 & 31;
}

std::uint32_t second_source(std::uint32_t word) {
  const auto opcode = opcode_of(word);
  const bool reads = opcode == store || opcode == branch || opcode == operation;
  return reads ? word >> 20 & 31 : 0;
}

}  // namespace

void ClockUse::add(std::uint32_t address, std::uint32_t instruction, std::uint64_t clock) {
  const bool is_long = (instruction & 3) == 3;
  const std::uint32_t bytes = is_long ? 4 : 2;
  const std::uint32_t word =
      is_long ? instruction
              : processor::expand_compressed(static_cast<std::uint16_t>(instruction)).value_or(0);
  ++instructions_;
  note_kind(word, bytes);
  note_dependence(word);
  if (last_ && last_->opcode == branch) note_branch(*last_, address);
  divide_clocks(word, address, clock);
  second_last_ = last_;
  last_ = Executed{.address = address,
                   .opcode = opcode_of(word),
                   .destination = has_destination(word) ? word >> 7 & 31 : 0,
                   .bytes = bytes,
                   .clock = clock,
                   .late = is_late(word)};
}

bool ClockUse::reads(std::uint32_t word, const std::optional<Executed>& writer) {
  return writer && writer->destination != 0 &&
         (writer->destination == first_source(word) || writer->destination == second_source(word));
}

// The clocks beyond the first, attributed to the first cause that applies; a division comes last,
// with its own clocks (rtl/processor/timing.md).
void ClockUse::divide_clocks(std::uint32_t word, std::uint32_t address, std::uint64_t clock) {
  if (!last_) {
    clocks_ = 1;
    return;
  }
  std::uint64_t rest = clock - last_->clock - 1;
  clocks_ += rest + 1;
  const auto put = [&](Waiting kind, std::uint64_t most) {
    const std::uint64_t part = std::min(rest, most);
    waited_[static_cast<std::size_t>(kind)] += part;
    rest -= part;
  };
  const bool division = divides(word);
  constexpr std::uint64_t waits_of_division = 17;
  const std::uint64_t most = division ? rest - std::min(rest, waits_of_division) : rest;
  if (last_->late && reads(word, last_)) put(Waiting::late_result, most);
  if (last_->opcode == jump || last_->opcode == jump_register) {
    put(Waiting::jump, most);
  } else if (last_->opcode == branch || address != last_->address + last_->bytes) {
    put(Waiting::branch, most);
  }
  put(division ? Waiting::division : Waiting::other, rest);
}

void ClockUse::note_kind(std::uint32_t word, std::uint32_t bytes) {
  if (bytes == 2) note(Event::compressed);
  if (divides(word)) note(Event::division);
  if (multiplies(word)) note(Event::multiplication);
  switch (opcode_of(word)) {
    case load:
      return note(Event::load);
    case store:
      return note(Event::store);
    case jump:
      return note(Event::jump_direct);
    case jump_register:
      return note(Event::jump_register);
    default:
      return;
  }
}

void ClockUse::note_branch(const Executed& branch, std::uint32_t next) {
  if (next == branch.address + branch.bytes) {
    note(Event::branch_not_taken);
  } else {
    note(next > branch.address ? Event::branch_taken_forward : Event::branch_taken_backward);
  }
}

void ClockUse::note_dependence(std::uint32_t word) {
  if (last_ && last_->late && reads(word, last_)) note(Event::late_result_read_next);
  if (second_last_ && second_last_->late && reads(word, second_last_) &&
      second_last_->destination != last_->destination) {
    note(Event::late_result_read_second);
  }
  if (!last_ || last_->late || last_->destination == 0) return;
  const auto opcode = opcode_of(word);
  const bool is_base = last_->destination == first_source(word);
  if (is_base && (opcode == load || opcode == store || opcode == jump_register)) {
    note(Event::result_is_next_address);
  }
  if (opcode == branch && (is_base || last_->destination == second_source(word))) {
    note(Event::result_is_next_condition);
  }
}

}  // namespace benchmarks
