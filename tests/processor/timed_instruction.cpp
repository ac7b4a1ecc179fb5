// SPDX-License-Identifier: Apache-2.0
// The rows of the table of times to which instructions belong.
#include "tests/processor/timed_instruction.hpp"

#include "sim/processor/encode.hpp"
#include "tests/processor/chip.hpp"

namespace processor {
namespace {

using encode::Word;

bool is_inside(Word address) { return address - Chip::memory_base < Chip::memory_size; }

Word half_word(const InstructionSetModel& model, Word address) {
  const std::size_t place = address - Chip::memory_base;
  return static_cast<Word>(model.memory()[place] | model.memory()[place + 1] << 8);
}

// As 32 bits.
std::optional<Word> word_at(const InstructionSetModel& model) {
  const Word address = model.program_counter();
  if (!is_inside(address)) return std::nullopt;
  const Word low = half_word(model, address);
  if ((low & 3) != 3) return expand_compressed(static_cast<std::uint16_t>(low));
  if (!is_inside(address + 2)) return std::nullopt;
  return low | half_word(model, address + 2) << 16;
}

std::int32_t immediate_of_load(Word word) { return static_cast<std::int32_t>(word) >> 20; }
std::int32_t immediate_of_store(Word word) {
  return static_cast<std::int32_t>((word & 0xFE000000) | (word & 0xF80) << 13) >> 20;
}

TimedInstruction access(const InstructionSetModel& model, Word word, bool is_store) {
  TimedInstruction timed{.first = word >> 15 & 31};
  const Word address =
      model.reg(timed.first) +
      static_cast<Word>(is_store ? immediate_of_store(word) : immediate_of_load(word));
  const Word size = 1u << (word >> 12 & 3);
  timed.second = is_store ? word >> 20 & 31 : 0;
  timed.late = !is_store;
  timed.on_bus = !is_inside(address) && address % size == 0;
  timed.row = is_store ? (timed.on_bus ? "store to a peripheral" : "store to memory")
                       : (timed.on_bus ? "load from a peripheral" : "load from memory");
  return timed;
}

bool is_taken(Word funct3, Word first, Word second) {
  const bool below = static_cast<std::int32_t>(first) < static_cast<std::int32_t>(second);
  const bool is_so = funct3 < 2 ? first == second : funct3 < 6 ? below : first < second;
  return is_so != ((funct3 & 1) != 0);
}

TimedInstruction branch(const InstructionSetModel& model, Word word) {
  TimedInstruction timed{.first = word >> 15 & 31, .second = word >> 20 & 31};
  const Word funct3 = word >> 12 & 7;
  const bool predicted_taken = (word >> 31) != 0 && (funct3 & 1) != 0;
  const bool taken = is_taken(funct3, model.reg(timed.first), model.reg(timed.second));
  timed.row =
      predicted_taken
          ? (taken ? "branch predicted taken, taken" : "branch predicted taken, not taken")
          : (taken ? "branch predicted not taken, taken" : "branch predicted not taken, not taken");
  return timed;
}

std::optional<TimedInstruction> zbb(Word word) {
  if (!bit_manipulation(word, 0, 0)) return std::nullopt;
  const Word funct7 = word >> 25, funct3 = word >> 12 & 7;
  const bool of_two = (word & 0x7F) == 0x33;
  const bool by_alu = funct7 == 0x20 || (funct7 == 0x30 && (of_two || funct3 == 5));
  TimedInstruction timed{.first = word >> 15 & 31, .second = of_two ? word >> 20 & 31 : 0};
  timed.late = !by_alu;
  if (timed.late) timed.row = "bit manipulation";
  return timed;
}

std::optional<TimedInstruction> operation(Word word) {
  const Word funct7 = word >> 25, funct3 = word >> 12 & 7;
  TimedInstruction timed{.first = word >> 15 & 31, .second = word >> 20 & 31};
  if (funct7 == 1) {
    timed.row = funct3 < 4 ? "multiplication" : "division";
    timed.late = funct3 < 4;
    return timed;
  }
  const bool is_alternate = funct7 == 0x20 && (funct3 == 0 || funct3 == 5);
  return funct7 == 0 || is_alternate ? std::optional(timed) : std::nullopt;
}

std::optional<TimedInstruction> immediate_operation(Word word) {
  const Word funct7 = word >> 25, funct3 = word >> 12 & 7;
  const bool is_shift = funct3 % 4 == 1;
  if (is_shift && funct7 != 0 && !(funct7 == 0x20 && funct3 == 5)) return std::nullopt;
  return TimedInstruction{.first = word >> 15 & 31};
}

std::optional<TimedInstruction> system(Word word) {
  const Word funct3 = word >> 12 & 7;
  if (word == encode::wait_for_interrupt()) return TimedInstruction{.row = "wfi", .sleeps = true};
  if (word == encode::trap_return()) return TimedInstruction{.row = "mret"};
  if (funct3 % 4 == 0) return std::nullopt;
  return TimedInstruction{
      .row = "CSR instruction", .first = funct3 < 4 ? word >> 15 & 31 : 0, .late = true};
}

}  // namespace

std::optional<TimedInstruction> timed_instruction(const InstructionSetModel& model, bool has_zbb) {
  const auto found = word_at(model);
  if (!found) return std::nullopt;
  const Word word = *found, funct3 = word >> 12 & 7;
  if (has_zbb) {
    if (const auto timed = zbb(word)) return timed;
  }
  switch (word & 0x7F) {
    case 0x37:
    case 0x17:
      return TimedInstruction{};
    case 0x6F:
      return TimedInstruction{.row = "jump"};
    case 0x67:
      if (funct3 != 0) return std::nullopt;
      return TimedInstruction{.row = "jump to a register", .first = word >> 15 & 31};
    case 0x63:
      return funct3 == 2 || funct3 == 3 ? std::nullopt : std::optional(branch(model, word));
    case 0x03:
      return funct3 == 3 || funct3 > 5 ? std::nullopt : std::optional(access(model, word, false));
    case 0x23:
      return funct3 > 2 ? std::nullopt : std::optional(access(model, word, true));
    case 0x13:
      return immediate_operation(word);
    case 0x33:
      return operation(word);
    case 0x0F:
      if (funct3 > 1) return std::nullopt;
      return funct3 == 1 ? TimedInstruction{.row = "fence.i"} : TimedInstruction{};
    case 0x73:
      return system(word);
    default:
      return std::nullopt;
  }
}

}  // namespace processor
