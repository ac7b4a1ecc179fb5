// SPDX-License-Identifier: Apache-2.0
// From the words of the manual to operations, with their times.
#include "sim/processor/decoder.hpp"

#include <array>

#include "sim/processor/instructions.hpp"
#include "sim/processor/times.hpp"

namespace processor {

namespace {

using Word = std::uint32_t;
using enum Operation;

constexpr std::array alu{add,          shift_left,  less,         below,
                         exclusive_or, shift_right, inclusive_or, conjunction};
constexpr std::array alu_immediate{add_immediate,   shift_left_immediate, less_immediate,
                                   below_immediate, xor_immediate,        shift_right_immediate,
                                   or_immediate,    and_immediate};
constexpr std::array multiplication{multiply, multiply_high, multiply_high_mixed,
                                    multiply_high_unsigned};
constexpr std::array branches{branch_equal, branch_not_equal, illegal,      illegal,
                              branch_less,  branch_not_less,  branch_below, branch_not_below};
constexpr std::array loads{load_byte,          load_half,          load_word, illegal,
                           load_unsigned_byte, load_unsigned_half, illegal,   illegal};
constexpr std::array stores{store_byte, store_half, store_word, illegal,
                            illegal,    illegal,    illegal,    illegal};

Word bits(Word word, unsigned high, unsigned low) {
  return word >> low & ((Word{1} << (high - low + 1)) - 1);
}

Word sign_extend(Word value, unsigned width) {
  const Word sign = Word{1} << (width - 1);
  return (value ^ sign) - sign;
}

class Decoder {
 public:
  Decoder(Word word, Word address, bool has_zbb)
      : word_(word), address_(address), has_zbb_(has_zbb) {}

  Instruction decoded() {
    const Operation operation = this->operation();
    result_.operation = operation;
    if (operation == illegal) result_ = {.operation = illegal};
    return result_;
  }

 private:
  Word funct3() const { return bits(word_, 14, 12); }
  Word funct7() const { return bits(word_, 31, 25); }

  void writes() {
    const auto index = static_cast<std::uint8_t>(bits(word_, 11, 7));
    result_.destination = index == 0 ? no_register : index;
  }
  void reads_first() { result_.first = static_cast<std::uint8_t>(bits(word_, 19, 15)); }
  void reads_second() { result_.second = static_cast<std::uint8_t>(bits(word_, 24, 20)); }

  Operation operation() {
    if (has_zbb_ && bit_manipulation(word_, 0, 0)) return manipulation();
    switch (bits(word_, 6, 0)) {
      case 0x37:
      case 0x17:
        writes();
        result_.immediate = (word_ & 0xffff'f000) + (bits(word_, 6, 0) == 0x17 ? address_ : 0);
        return constant;
      case 0x6f:
        writes();
        result_.immediate =
            address_ + sign_extend(bits(word_, 31, 31) << 20 | bits(word_, 19, 12) << 12 |
                                       bits(word_, 20, 20) << 11 | bits(word_, 30, 21) << 1,
                                   21);
        return jump;
      case 0x67:
        writes();
        reads_first();
        result_.immediate = sign_extend(bits(word_, 31, 20), 12);
        return funct3() == 0 ? jump_register : illegal;
      case 0x63:
        return branch();
      case 0x03:
        writes();
        reads_first();
        result_.immediate = sign_extend(bits(word_, 31, 20), 12);
        return loads[funct3()];
      case 0x23:
        reads_first();
        reads_second();
        result_.immediate = sign_extend(funct7() << 5 | bits(word_, 11, 7), 12);
        return stores[funct3()];
      case 0x13:
        return of_immediate();
      case 0x33:
        return of_registers();
      case 0x0f:
        return funct3() == 0 ? fence : funct3() == 1 ? Operation::fence_i : illegal;
      case 0x73:
        return system();
      default:
        return illegal;
    }
  }

  // Backward bne, bge and bgeu are predicted taken.
  Operation branch() {
    reads_first();
    reads_second();
    result_.immediate =
        address_ + sign_extend(bits(word_, 31, 31) << 12 | bits(word_, 7, 7) << 11 |
                                   bits(word_, 30, 25) << 5 | bits(word_, 11, 8) << 1,
                               13);
    const bool predicted_taken = bits(word_, 31, 31) != 0 && (funct3() & 1) != 0;
    result_.behind_taken = predicted_taken ? times::predicted_taken : times::mispredicted;
    result_.behind_not_taken = predicted_taken ? times::mispredicted : std::uint8_t{0};
    return branches[funct3()];
  }

  Operation of_immediate() {
    writes();
    reads_first();
    result_.immediate = sign_extend(bits(word_, 31, 20), 12);
    if (funct3() % 4 != 1) return alu_immediate[funct3()];
    result_.immediate = bits(word_, 24, 20);
    if (funct7() == 0) return alu_immediate[funct3()];
    return funct7() == 0x20 && funct3() == 5 ? shift_arithmetic_immediate : illegal;
  }

  Operation of_registers() {
    writes();
    reads_first();
    reads_second();
    switch (funct7()) {
      case 0x00:
        return alu[funct3()];
      case 0x01:
        return funct3() < 4 ? multiplication[funct3()] : divide;
      case 0x20:
        return funct3() == 0 ? subtract : funct3() == 5 ? shift_arithmetic : illegal;
      default:
        return illegal;
    }
  }

  Operation manipulation() {
    writes();
    reads_first();
    const bool of_two = bits(word_, 6, 0) == 0x33;
    if (of_two) reads_second();
    const bool by_alu = funct7() == 0x20 || (funct7() == 0x30 && (of_two || funct3() == 5));
    return by_alu ? manipulate : manipulate_late;
  }

  Operation system() {
    switch (word_) {
      case 0x0000'0073:
        return environment_call;
      case 0x0010'0073:
        return breakpoint;
      case 0x3020'0073:
        return Operation::trap_return;
      case 0x1050'0073:
        return wait_for_interrupt;
      default:
        break;
    }
    if (funct3() % 4 == 0) return illegal;
    writes();
    if (funct3() < 4) reads_first();
    result_.immediate = bits(word_, 31, 20);
    return csr;
  }

  Word word_, address_;
  bool has_zbb_;
  Instruction result_;
};

}  // namespace

Instruction decode(Word word, Word address, bool has_zbb) {
  const bool is_compressed = (word & 3) != 3;
  const Word found = is_compressed ? word & 0xffff : word;
  Instruction instruction{.operation = illegal};
  if (!is_compressed) {
    instruction = Decoder(word, address, has_zbb).decoded();
  } else if (const auto expanded = expand_compressed(static_cast<std::uint16_t>(found))) {
    instruction = Decoder(*expanded, address, has_zbb).decoded();
  }
  instruction.word = found;
  instruction.bytes = is_compressed ? 2 : 4;
  return instruction;
}

}  // namespace processor
