// SPDX-License-Identifier: Apache-2.0
// Random instructions of machine mode.
#include <array>

#include "tests/processor/random_instructions.hpp"
#include "tests/processor/test_device.hpp"

namespace processor {
namespace {

using encode::Word;

constexpr std::int32_t interrupt_offset = TestDevice::interrupt_register - TestDevice::base;

// QEMU 10.0 keeps bit 0 of what is written to mepc, and reads it back: there it is 0.
void add_even_write_of_mepc(RandomText& text, Word kind, bool from_constant, Word operand) {
  constexpr Word clear = 3;
  if (from_constant) {
    text.emit(encode::csr(kind + 4, text.destination(), csr_numbers::mepc, operand & ~Word{1}));
  } else if (text.one_in(2)) {
    text.emit(encode::csr(clear, text.destination(), csr_numbers::mepc, operand));
  } else {
    text.emit(
        encode::csr(kind, text.destination(), csr_numbers::mepc, random_registers::data_base));
  }
}

// Of the last: one that does not exist, and one that cannot be written.
void add_portable_csr(RandomText& text) {
  constexpr std::array<Word, 7> addresses{0x340, 0x340, 0x341, 0x343, 0x301, 0x7C0, 0xF14};
  const Word address = addresses[text.below(addresses.size())];
  const Word kind = address == 0x301 ? 2 : 1 + text.below(3);
  const bool from_constant = text.one_in(3);
  const Word operand = address == 0x301 ? 0 : text.source();
  if (address == csr_numbers::mepc) {
    return add_even_write_of_mepc(text, kind, from_constant, operand);
  }
  text.emit(encode::csr(from_constant ? kind + 4 : kind, text.destination(), address, operand));
}

void add_csr(RandomText& text) {
  if (text.settings.portable) return add_portable_csr(text);
  constexpr std::array<Word, 24> addresses{0x300, 0x301, 0x310, 0x320, 0x340, 0x340, 0x340, 0x341,
                                           0x342, 0x343, 0x344, 0x7A0, 0xB00, 0xB02, 0xB82, 0xB03,
                                           0x323, 0xC00, 0xC02, 0xC82, 0xF11, 0xF14, 0x180, 0x3A0};
  const Word kind = 1 + text.below(3);
  const Word address = text.one_in(10) ? text.below(4096) : addresses[text.below(addresses.size())];
  // The handler must stay where it is; interrupts are switched on only where they are wanted.
  const bool keep = address == csr_numbers::mtvec ||
                    (!text.settings.interrupts &&
                     (address == csr_numbers::mie || address == csr_numbers::mstatus));
  if (keep) return text.emit(encode::csr(2, text.destination(), address, 0));
  text.emit(
      encode::csr(text.one_in(3) ? kind + 4 : kind, text.destination(), address, text.source()));
}

}  // namespace

void add_random_system_instruction(RandomText& text) {
  switch (text.below(text.settings.interrupts ? 9 : 6)) {
    case 0:
      return text.emit(encode::environment_call());
    case 1:
      return text.emit(encode::breakpoint());
    case 2:
      return text.emit(text.one_in(2) ? encode::fence() : encode::fence_i());
    case 3:
    case 4:
    case 5:
      return add_csr(text);
    case 6:
      return text.emit(
          encode::store(2, text.source(), random_registers::bus_base, interrupt_offset));
    case 7:
      return text.emit(
          encode::csr(text.one_in(4) ? 1 : 2, text.destination(), csr_numbers::mie, text.source()));
    default:
      return text.emit(
          encode::csr(text.one_in(4) ? 7 : 6, text.destination(), csr_numbers::mstatus, 8));
  }
}

}  // namespace processor
