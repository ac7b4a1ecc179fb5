// SPDX-License-Identifier: Apache-2.0
// Fetch, and the instructions of RV32IM but those of SYSTEM, for which see
// instruction_set_model_system.cpp; C and Zbb are shared with sim/processor.
#include "tests/processor/instruction_set_model.hpp"

#include <limits>
#include <utility>

namespace processor {
namespace {

constexpr std::uint32_t memory_base = 0x80000000;
constexpr std::uint32_t fetch_access = 1, illegal_instruction = 2;
constexpr std::uint32_t load_misaligned = 4, load_access = 5, store_misaligned = 6,
                        store_access = 7;

std::uint32_t field(std::uint32_t word, unsigned high, unsigned low) {
  return word >> low & ((1u << (high - low + 1)) - 1);
}

std::uint32_t sign_extend(std::uint32_t value, unsigned bits) {
  const std::uint32_t sign = 1u << (bits - 1);
  return (value ^ sign) - sign;
}

std::int32_t as_signed(std::uint32_t value) { return static_cast<std::int32_t>(value); }

std::optional<std::uint32_t> integer_operation(unsigned funct3, unsigned funct7, std::uint32_t a,
                                               std::uint32_t b) {
  const unsigned distance = b & 31;
  if (funct7 == 0x20) {
    if (funct3 == 0) return a - b;
    if (funct3 == 5) return static_cast<std::uint32_t>(as_signed(a) >> distance);
    return std::nullopt;
  }
  if (funct7 != 0) return std::nullopt;
  switch (funct3) {
    case 0:
      return a + b;
    case 1:
      return a << distance;
    case 2:
      return as_signed(a) < as_signed(b) ? 1 : 0;
    case 3:
      return a < b ? 1 : 0;
    case 4:
      return a ^ b;
    case 5:
      return a >> distance;
    case 6:
      return a | b;
    default:
      return a & b;
  }
}

std::uint32_t multiply_or_divide(unsigned funct3, std::uint32_t a, std::uint32_t b) {
  const auto signed_a = static_cast<std::int64_t>(as_signed(a));
  const auto signed_b = static_cast<std::int64_t>(as_signed(b));
  const auto upper = [](auto product) {
    return static_cast<std::uint32_t>(static_cast<std::uint64_t>(product) >> 32);
  };
  const bool overflows =
      as_signed(a) == std::numeric_limits<std::int32_t>::min() && b == 0xFFFFFFFF;
  switch (funct3) {
    case 0:
      return a * b;
    case 1:
      return upper(signed_a * signed_b);
    case 2:
      return upper(signed_a * static_cast<std::int64_t>(b));
    case 3:
      return upper(static_cast<std::uint64_t>(a) * b);
    case 4:
      return b == 0 ? 0xFFFFFFFF : overflows ? a : static_cast<std::uint32_t>(signed_a / signed_b);
    case 5:
      return b == 0 ? 0xFFFFFFFF : a / b;
    case 6:
      return b == 0 ? a : overflows ? 0 : static_cast<std::uint32_t>(signed_a % signed_b);
    default:
      return b == 0 ? a : a % b;
  }
}

}  // namespace

InstructionSetModel::InstructionSetModel(std::vector<std::uint8_t> image, std::size_t memory_size,
                                         bool has_zbb)
    : memory_(std::move(image)), has_zbb_(has_zbb) {
  memory_.resize(memory_size);
}

bool InstructionSetModel::in_memory(std::uint32_t address) const {
  return address - memory_base < memory_.size();
}

std::uint32_t InstructionSetModel::word_at(std::uint32_t address) const {
  const std::size_t place = (address - memory_base) & ~3u;
  return static_cast<std::uint32_t>(memory_[place] | memory_[place + 1] << 8 |
                                    memory_[place + 2] << 16) |
         static_cast<std::uint32_t>(memory_[place + 3]) << 24;
}

std::uint32_t InstructionSetModel::half_word_at(std::uint32_t address) const {
  return word_at(address) >> (8 * (address & 2)) & 0xFFFF;
}

std::optional<InstructionSetModel::Exception> InstructionSetModel::fetch(Step& step) const {
  for (const std::uint32_t place : {program_counter_, program_counter_ + 2}) {
    if (!in_memory(place)) return Exception{fetch_access, place};
    step.instruction |= half_word_at(place) << (place == program_counter_ ? 0 : 16);
    if ((step.instruction & 3) != 3) break;
  }
  return std::nullopt;
}

void InstructionSetModel::write_register(unsigned index, std::uint32_t value, Step& step) {
  if (index == 0) return;
  registers_[index] = value;
  step.destination = index;
  step.value = value;
}

Step InstructionSetModel::step() {
  Step step;
  step.address = program_counter_;
  counter_written_ = false;
  // As it was before the instruction, which may change it (as in the specification's Sail model).
  const bool counts = (mcountinhibit_ & 4) == 0;
  std::uint32_t next = program_counter_ + 4;
  auto exception = fetch(step);
  if (!exception) {
    std::optional<std::uint32_t> word = step.instruction;
    if ((step.instruction & 3) != 3) {
      next = program_counter_ + 2;
      word = expand_compressed(static_cast<std::uint16_t>(step.instruction));
    }
    exception = word ? execute(*word, next, step)
                     : std::optional(Exception{illegal_instruction, step.instruction});
  }
  if (exception) {
    step = Step{.trap = true, .address = program_counter_, .instruction = step.instruction};
    enter_trap(exception->cause, false, exception->value);
    return step;
  }
  if (!counter_written_ && counts) ++instret_;
  program_counter_ = next;
  return step;
}

std::optional<InstructionSetModel::Exception> InstructionSetModel::execute(std::uint32_t word,
                                                                           std::uint32_t& next,
                                                                           Step& step) {
  const unsigned rd = field(word, 11, 7), funct3 = field(word, 14, 12),
                 funct7 = field(word, 31, 25);
  const std::uint32_t a = registers_[field(word, 19, 15)], b = registers_[field(word, 24, 20)];
  const std::uint32_t immediate = sign_extend(field(word, 31, 20), 12);
  const Exception illegal{illegal_instruction, word};
  if (has_zbb_) {
    if (const auto value = bit_manipulation(word, a, b)) {
      write_register(rd, *value, step);
      return std::nullopt;
    }
  }
  switch (word & 0x7F) {
    case 0x37:
      write_register(rd, word & 0xFFFFF000, step);
      return std::nullopt;
    case 0x17:
      write_register(rd, program_counter_ + (word & 0xFFFFF000), step);
      return std::nullopt;
    case 0x6F: {
      const std::uint32_t offset =
          sign_extend(field(word, 31, 31) << 20 | field(word, 19, 12) << 12 |
                          field(word, 20, 20) << 11 | field(word, 30, 21) << 1,
                      21);
      write_register(rd, next, step);
      next = program_counter_ + offset;
      return std::nullopt;
    }
    case 0x67: {
      if (funct3 != 0) return illegal;
      write_register(rd, next, step);
      next = (a + immediate) & ~1u;
      return std::nullopt;
    }
    case 0x63: {
      const std::uint32_t offset =
          sign_extend(field(word, 31, 31) << 12 | field(word, 7, 7) << 11 |
                          field(word, 30, 25) << 5 | field(word, 11, 8) << 1,
                      13);
      bool taken = false;
      switch (funct3) {
        case 0:
          taken = a == b;
          break;
        case 1:
          taken = a != b;
          break;
        case 4:
          taken = as_signed(a) < as_signed(b);
          break;
        case 5:
          taken = as_signed(a) >= as_signed(b);
          break;
        case 6:
          taken = a < b;
          break;
        case 7:
          taken = a >= b;
          break;
        default:
          return illegal;
      }
      if (taken) next = program_counter_ + offset;
      return std::nullopt;
    }
    case 0x03:
      return load(word, step);
    case 0x23:
      return store(word);
    case 0x13: {
      const bool shift = funct3 == 1 || funct3 == 5;
      const auto value = integer_operation(funct3, shift ? funct7 : 0, a, immediate);
      if (!value) return illegal;
      write_register(rd, *value, step);
      return std::nullopt;
    }
    case 0x33: {
      const auto value =
          funct7 == 1 ? multiply_or_divide(funct3, a, b) : integer_operation(funct3, funct7, a, b);
      if (!value) return illegal;
      write_register(rd, *value, step);
      return std::nullopt;
    }
    case 0x0F:
      return funct3 <= 1 ? std::nullopt : std::optional(illegal);
    case 0x73:
      return execute_system(word, next, step);
    default:
      return illegal;
  }
}

std::optional<InstructionSetModel::Exception> InstructionSetModel::load(std::uint32_t word,
                                                                        Step& step) {
  const unsigned funct3 = field(word, 14, 12);
  if (funct3 == 3 || funct3 > 5) return Exception{illegal_instruction, word};
  const std::uint32_t address =
      registers_[field(word, 19, 15)] + sign_extend(field(word, 31, 20), 12);
  const unsigned bytes = 1u << (funct3 & 3);
  if (address % bytes != 0) return Exception{load_misaligned, address};
  std::uint32_t loaded = 0;
  if (in_memory(address)) {
    loaded = word_at(address);
  } else {
    const auto answer = device_.read(address);
    if (!answer) return Exception{load_access, address};
    loaded = *answer;
  }
  loaded >>= 8 * (address % 4);
  if (bytes == 1) loaded = funct3 == 0 ? sign_extend(loaded & 0xFF, 8) : loaded & 0xFF;
  if (bytes == 2) loaded = funct3 == 1 ? sign_extend(loaded & 0xFFFF, 16) : loaded & 0xFFFF;
  write_register(field(word, 11, 7), loaded, step);
  return std::nullopt;
}

std::optional<InstructionSetModel::Exception> InstructionSetModel::store(std::uint32_t word) {
  const unsigned funct3 = field(word, 14, 12);
  if (funct3 > 2) return Exception{illegal_instruction, word};
  const std::uint32_t offset = sign_extend(field(word, 31, 25) << 5 | field(word, 11, 7), 12);
  const std::uint32_t address = registers_[field(word, 19, 15)] + offset;
  const std::uint32_t data = registers_[field(word, 24, 20)];
  const unsigned bytes = 1u << funct3;
  if (address % bytes != 0) return Exception{store_misaligned, address};
  if (in_memory(address)) {
    for (unsigned index = 0; index < bytes; ++index) {
      memory_[address - memory_base + index] = static_cast<std::uint8_t>(data >> (8 * index));
    }
    return std::nullopt;
  }
  const unsigned lanes = ((1u << bytes) - 1) << (address % 4);
  if (!device_.write(address, lanes, data << (8 * (address % 4)))) {
    return Exception{store_access, address};
  }
  return std::nullopt;
}

}  // namespace processor
