// SPDX-License-Identifier: Apache-2.0
// The compressed instructions in the instruction-set model: each becomes the longer one for which
// it stands, field by field as the tables of the manual's chapter on extension C give them.
#include <array>

#include "sim/processor/encode.hpp"
#include "sim/processor/instructions.hpp"

namespace processor {
namespace {

using encode::Word;

constexpr Word stack_pointer = 2, link = 1;

// One compressed instruction and its fields.
class Fields {
 public:
  explicit Fields(std::uint16_t bits) : bits_(bits) {}

  Word bit(unsigned index) const { return bits_ >> index & 1u; }
  Word field(unsigned high, unsigned low) const {
    return bits_ >> low & ((1u << (high - low + 1)) - 1);
  }
  Word quadrant() const { return field(1, 0); }
  Word funct3() const { return field(15, 13); }
  Word rd() const { return field(11, 7); }
  Word rs2() const { return field(6, 2); }
  // Registers x8 to x15 of the short forms.
  Word short_upper() const { return 8 + field(9, 7); }
  Word short_lower() const { return 8 + field(4, 2); }

  std::int32_t immediate6() const {
    return static_cast<std::int32_t>(field(6, 2)) - static_cast<std::int32_t>(bit(12)) * 32;
  }
  std::int32_t add_to_sp_offset() const {
    return number(field(10, 7) << 6 | field(12, 11) << 4 | bit(5) << 3 | bit(6) << 2);
  }
  std::int32_t add_sp_amount() const {
    return number(field(4, 3) << 7 | bit(5) << 6 | bit(2) << 5 | bit(6) << 4) -
           number(bit(12) << 9);
  }
  std::int32_t word_offset() const {
    return number(bit(5) << 6 | field(12, 10) << 3 | bit(6) << 2);
  }
  std::int32_t load_from_sp_offset() const {
    return number(field(3, 2) << 6 | bit(12) << 5 | field(6, 4) << 2);
  }
  std::int32_t store_to_sp_offset() const { return number(field(8, 7) << 6 | field(12, 9) << 2); }
  std::int32_t jump_offset() const {
    return number(bit(8) << 10 | field(10, 9) << 8 | bit(6) << 7 | bit(7) << 6 | bit(2) << 5 |
                  bit(11) << 4 | field(5, 3) << 1) -
           number(bit(12) << 11);
  }
  std::int32_t branch_offset() const {
    return number(field(6, 5) << 6 | bit(2) << 5 | field(11, 10) << 3 | field(4, 3) << 1) -
           number(bit(12) << 8);
  }

 private:
  static std::int32_t number(Word value) { return static_cast<std::int32_t>(value); }

  unsigned bits_;
};

std::optional<Word> expand_quadrant_0(const Fields& fields) {
  switch (fields.funct3()) {
    case 0:
      if (fields.add_to_sp_offset() == 0) return std::nullopt;
      return encode::add_immediate(fields.short_lower(), stack_pointer, fields.add_to_sp_offset());
    case 2:
      return encode::load(2, fields.short_lower(), fields.short_upper(), fields.word_offset());
    case 6:
      return encode::store(2, fields.short_lower(), fields.short_upper(), fields.word_offset());
    default:
      return std::nullopt;
  }
}

std::optional<Word> expand_arithmetic(const Fields& fields) {
  const Word rd = fields.short_upper();
  switch (fields.field(11, 10)) {
    case 0:
    case 1:
      if (fields.bit(12) != 0) return std::nullopt;
      return encode::operation_immediate(
          5, rd, rd, static_cast<std::int32_t>(fields.rs2() | fields.bit(10) << 10));
    case 2:
      return encode::operation_immediate(7, rd, rd, fields.immediate6());
    default: {
      if (fields.bit(12) != 0) return std::nullopt;
      constexpr std::array<Word, 4> funct3{0, 4, 6, 7};
      const Word which = fields.field(6, 5);
      return encode::operation(funct3[which], which == 0 ? 0x20 : 0, rd, rd, fields.short_lower());
    }
  }
}

std::optional<Word> expand_quadrant_1(const Fields& fields) {
  const Word rd = fields.rd();
  switch (fields.funct3()) {
    case 0:
      return encode::add_immediate(rd, rd, fields.immediate6());
    case 1:
      return encode::jump_and_link(link, fields.jump_offset());
    case 2:
      return encode::add_immediate(rd, 0, fields.immediate6());
    case 3:
      if (fields.immediate6() == 0) return std::nullopt;
      if (rd == stack_pointer) {
        return encode::add_immediate(stack_pointer, stack_pointer, fields.add_sp_amount());
      }
      return encode::load_upper(rd, static_cast<Word>(fields.immediate6()) << 12);
    case 4:
      return expand_arithmetic(fields);
    case 5:
      return encode::jump_and_link(0, fields.jump_offset());
    default:
      return encode::branch(fields.funct3() - 6, fields.short_upper(), 0, fields.branch_offset());
  }
}

std::optional<Word> expand_quadrant_2(const Fields& fields) {
  const Word rd = fields.rd(), rs2 = fields.rs2();
  switch (fields.funct3()) {
    case 0:
      if (fields.bit(12) != 0) return std::nullopt;
      return encode::operation_immediate(1, rd, rd, static_cast<std::int32_t>(rs2));
    case 2:
      if (rd == 0) return std::nullopt;
      return encode::load(2, rd, stack_pointer, fields.load_from_sp_offset());
    case 4:
      if (rs2 != 0) return encode::operation(0, 0, rd, fields.bit(12) != 0 ? rd : 0, rs2);
      if (rd != 0) return encode::jump_and_link_register(fields.bit(12) != 0 ? link : 0, rd, 0);
      if (fields.bit(12) != 0) return encode::breakpoint();
      return std::nullopt;
    case 6:
      return encode::store(2, rs2, stack_pointer, fields.store_to_sp_offset());
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<std::uint32_t> expand_compressed(std::uint16_t instruction) {
  const Fields fields(instruction);
  switch (fields.quadrant()) {
    case 0:
      return expand_quadrant_0(fields);
    case 1:
      return expand_quadrant_1(fields);
    default:
      return expand_quadrant_2(fields);
  }
}

}  // namespace processor
