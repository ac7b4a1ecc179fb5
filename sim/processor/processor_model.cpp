// SPDX-License-Identifier: Apache-2.0
// Reset, and the memory with what has been decoded of it.
#include "sim/processor/processor_model.hpp"

#include <array>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace processor {

namespace {

// From the first clock without reset to that of the first instruction.
constexpr Clock clocks_to_first_instruction = 3;

}  // namespace

ProcessorModel::ProcessorModel(std::uint32_t memory_bytes, bool has_zbb)
    : memory_(memory_bytes),
      size_(memory_bytes),
      has_zbb_(has_zbb),
      decoded_(memory_bytes / 2),
      holds_code_((memory_bytes >> code_block_shift) + 2) {}

void ProcessorModel::reset(Clock released) {
  MachineState state;
  state.registers = state_.registers;
  state.scratch = state_.scratch;
  state.exception_address = state_.exception_address;
  state.trap_value = state_.trap_value;
  state.instructions = state_.instructions;
  state.traps = state_.traps;
  state.slept_clocks = state_.slept_clocks;
  state.begins = released + clocks_to_first_instruction;
  state.open_from = state.begins;
  state.cycles.set(released, 0);
  state.retired.set(state.instructions, 0);
  state_ = state;
  complete_ = released;
  change_waits_ = false;
  mark();
}

const Instruction& ProcessorModel::decoded_at(std::uint32_t place) {
  Instruction& instruction = decoded_[place >> 1];
  if (instruction.operation != Operation::undecoded) return instruction;
  std::uint16_t lower = 0, upper = 0;
  std::memcpy(&lower, &memory_[place], sizeof lower);
  const bool is_word = (lower & 3) == 3;
  const bool has_both = place + 2 < size_;
  if (is_word && has_both) std::memcpy(&upper, &memory_[place + 2], sizeof upper);
  instruction =
      decode(std::uint32_t{lower} | std::uint32_t{upper} << 16, memory_start + place, has_zbb_);
  if (is_word && !has_both) instruction = {.operation = Operation::fetch_fault};
  holds_code_[place >> code_block_shift] = 1;
  holds_code_[(place + 2) >> code_block_shift] = 1;
  return instruction;
}

void ProcessorModel::forget_code(std::uint32_t place, unsigned bytes) {
  const std::uint32_t first = place >> 1;
  const std::uint32_t last = (place + bytes - 1) >> 1;
  for (std::uint32_t i = first == 0 ? 0 : first - 1; i <= last; ++i) {
    decoded_[i].operation = Operation::undecoded;
  }
}

std::uint32_t ProcessorModel::word_at(std::uint32_t place) const {
  std::uint32_t word = 0;
  std::memcpy(&word, &memory_[place], sizeof word);
  return word;
}

void ProcessorModel::put_word(std::uint32_t place, std::uint32_t word) {
  std::memcpy(&memory_[place], &word, sizeof word);
  if (holds_code_[place >> code_block_shift] != 0) forget_code(place, sizeof word);
}

namespace {

std::uint32_t checked_place(std::uint32_t address, std::uint32_t size) {
  const std::uint32_t place = (address - ProcessorModel::memory_start) & ~3U;
  if (place < size) return place;
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "no memory at %#010x", address);
  throw std::out_of_range(text.data());
}

}  // namespace

std::uint32_t ProcessorModel::read_memory(std::uint32_t address) const {
  return word_at(checked_place(address, size_));
}

void ProcessorModel::write_memory(std::uint32_t address, std::uint32_t word) {
  put_word(checked_place(address, size_), word);
}

}  // namespace processor
