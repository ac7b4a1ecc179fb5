// SPDX-License-Identifier: Apache-2.0
// Programs of random instructions, with what makes them end.
#include "tests/processor/random_program.hpp"

#include "tests/processor/random_instructions.hpp"
#include "tests/processor/test_device.hpp"

namespace processor {
namespace {

using encode::Word;
using random_registers::bus_base;
using random_registers::data_base;
using random_registers::handler_second;
using random_registers::jump_base;
using random_registers::short_data_base;
using random_registers::stack_pointer;
using random_registers::tohost_base;

constexpr Word data_address = 0x8000C000, stack_address = 0x8000D000,
               short_data_address = 0x8000E000;
// Nothing answers there, on any machine.
constexpr Word nowhere = 0xF0004000;
constexpr std::size_t instructions_of_prologue = 120;
// Jumps may lead a little beyond the end.
constexpr std::size_t instructions_of_epilogue = 40;
// Passes left, in the word below `tohost`.
constexpr std::int32_t passes_offset = -4;

void load_constant(RandomText& text, Word rd, Word value) {
  text.emit(encode::load_upper(rd, value + 0x800));
  text.emit(encode::add_immediate(rd, rd, static_cast<std::int32_t>(value << 20) >> 20));
}

// Interrupts: the device is made quiet. Exceptions: the instruction is skipped.
void add_handler(RandomText& text) {
  constexpr Word handler = random_registers::handler;
  constexpr std::size_t handler_instructions = 16;
  text.program.add_distance(0, handler_instructions + 1,
                            [](std::int32_t bytes) { return encode::jump_and_link(0, bytes); });
  text.emit(encode::csr(2, handler, csr_numbers::mcause, 0));
  text.emit(encode::branch(5, handler, 0, 20));
  text.emit(encode::store(2, 0, bus_base, 0x100));
  text.emit(encode::csr(2, handler_second, csr_numbers::mip, 0));
  text.emit(encode::branch(1, handler_second, 0, -8));
  text.emit(encode::jump_and_link(0, 40));
  text.emit(encode::csr(2, handler, csr_numbers::mepc, 0));
  text.emit(encode::load(5, handler_second, handler, 0));
  text.emit(encode::operation_immediate(7, handler_second, handler_second, 3));
  text.emit(encode::add_immediate(handler_second, handler_second, -3));
  text.emit(encode::add_immediate(handler, handler, 2));
  text.emit(encode::branch(1, handler_second, 0, 8));
  text.emit(encode::add_immediate(handler, handler, 2));
  text.emit(encode::csr(1, 0, csr_numbers::mepc, handler));
  text.emit(encode::csr(2, handler_second, csr_numbers::mtval, 0));
  text.emit(encode::trap_return());
}

void add_prologue(RandomText& text) {
  add_handler(text);
  load_constant(text, random_registers::handler, 0x80000004);
  text.emit(encode::csr(1, 0, csr_numbers::mtvec, random_registers::handler));
  load_constant(text, tohost_base, random_program_tohost);
  load_constant(text, bus_base, text.settings.portable ? nowhere : TestDevice::base);
  load_constant(text, data_base, data_address);
  load_constant(text, short_data_base, short_data_address);
  for (Word index = 1; index <= jump_base; ++index) {
    if (index != short_data_base) load_constant(text, index, text.interesting_value());
  }
  load_constant(text, 1, text.settings.passes);
  text.emit(encode::store(2, 1, tohost_base, passes_offset));
  while (text.program.size() < instructions_of_prologue - 2) text.emit(encode::nop());
}

// Stored values are checked by loading them.
void read_back(RandomText& text) {
  for (std::int32_t offset = -128; offset < 128; offset += 4) {
    text.emit(encode::load(2, 1, data_base, offset));
    text.emit(encode::load(2, 1, short_data_base, offset + 128));
  }
}

void repeat_from(RandomText& text, std::size_t body) {
  text.emit(encode::load(2, jump_base, tohost_base, passes_offset));
  text.emit(encode::add_immediate(jump_base, jump_base, -1));
  text.emit(encode::store(2, jump_base, tohost_base, passes_offset));
  text.emit(encode::branch(0, jump_base, 0, 8));
  text.program.add_distance(text.program.size(), body,
                            [](std::int32_t bytes) { return encode::jump_and_link(0, bytes); });
}

void tell_the_end(RandomText& text) {
  text.emit(encode::add_immediate(1, 0, 1));
  text.emit(encode::store(2, 1, tohost_base, 0));
  text.emit(encode::jump_and_link(0, 0));
}

}  // namespace

std::vector<std::uint8_t> random_program(std::uint32_t seed,
                                         const RandomProgramSettings& settings) {
  RandomText text(seed, settings);
  add_prologue(text);
  const std::size_t body = text.program.size();
  load_constant(text, stack_pointer, stack_address);
  while (text.program.size() < instructions_of_prologue + settings.length) {
    text.one_in(2) ? add_random_half_word(text) : add_random_word(text);
  }
  for (std::size_t count = 0; count < instructions_of_epilogue; ++count) text.emit(encode::nop());
  read_back(text);
  repeat_from(text, body);
  tell_the_end(text);
  return text.program.image();
}

}  // namespace processor
