// SPDX-License-Identifier: Apache-2.0
// Programs of random instructions.
#include "tests/processor/random_program.hpp"

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <utility>

#include "tests/processor/encode_compressed.hpp"
#include "tests/processor/program_builder.hpp"
#include "tests/processor/test_device.hpp"

namespace processor {
namespace {

using encode::Word;

namespace compressed = encode::compressed;

// Registers with a fixed meaning; the rest is free for random results.
constexpr Word stack_pointer = 2, short_data_base = 8;
constexpr Word handler_register = 26, handler_second = 27, jump_base = 28, tohost_base = 29;
constexpr Word bus_base = 30, data_base = 31;
constexpr Word data_address = 0x8000C000, stack_address = 0x8000D000,
               short_data_address = 0x8000E000;
constexpr Word mstatus = 0x300, mie = 0x304, mtvec = 0x305, mepc = 0x341, mcause = 0x342;
constexpr std::size_t instructions_of_prologue = 120;
// Nothing answers there, on any machine.
constexpr Word nowhere = 0xF0004000;
// Passes left, in the word below the one that tells the end.
constexpr std::int32_t passes_offset = -4;
// Jumps may lead a little beyond the end.
constexpr std::size_t instructions_of_epilogue = 40;

class Generator {
 public:
  Generator(std::uint32_t seed, const RandomProgramSettings& settings)
      : random_(seed), settings_(settings) {}

  std::vector<std::uint8_t> generate() {
    prologue();
    const std::size_t body = program_.size();
    load_constant(stack_pointer, stack_address);
    while (program_.size() < instructions_of_prologue + settings_.length) {
      one_in(2) ? add_short_instruction() : add_instruction();
    }
    for (std::size_t count = 0; count < instructions_of_epilogue; ++count) emit(encode::nop());
    read_back();
    repeat(body);
    emit(encode::add_immediate(1, 0, 1));
    emit(encode::store(2, 1, tohost_base, 0));
    emit(encode::jump_and_link(0, 0));
    return program_.image();
  }

 private:
  Word below(Word limit) { return static_cast<Word>(random_() % limit); }
  bool one_in(Word count) { return below(count) == 0; }
  void emit(Word instruction) { program_.add(instruction); }
  Word source() { return below(26); }
  Word destination() {
    while (true) {
      const Word index = below(26);
      if (index != stack_pointer && index != short_data_base) return index;
    }
  }
  Word short_source() { return 8 + below(8); }
  Word short_destination() { return 9 + below(7); }
  std::int32_t small_immediate() { return static_cast<std::int32_t>(below(4096)) - 2048; }
  std::int32_t tiny_immediate() { return static_cast<std::int32_t>(below(64)) - 32; }

  // What was stored is looked at by loading it.
  void read_back() {
    for (std::int32_t offset = -128; offset < 128; offset += 4) {
      emit(encode::load(2, 1, data_base, offset));
      emit(encode::load(2, 1, short_data_base, offset + 128));
    }
  }

  void repeat(std::size_t body) {
    emit(encode::load(2, jump_base, tohost_base, passes_offset));
    emit(encode::add_immediate(jump_base, jump_base, -1));
    emit(encode::store(2, jump_base, tohost_base, passes_offset));
    emit(encode::branch(0, jump_base, 0, 8));
    program_.add_distance(program_.size(), body,
                          [](std::int32_t bytes) { return encode::jump_and_link(0, bytes); });
  }

  void load_constant(Word rd, Word value) {
    emit(encode::load_upper(rd, value + 0x800));
    emit(encode::add_immediate(rd, rd, static_cast<std::int32_t>(value << 20) >> 20));
  }

  // Interrupts: the device is made quiet. Exceptions: the instruction is skipped.
  void prologue() {
    constexpr std::size_t handler_instructions = 16;
    program_.add_distance(0, handler_instructions + 1,
                          [](std::int32_t bytes) { return encode::jump_and_link(0, bytes); });
    emit(encode::csr(2, handler_register, mcause, 0));
    emit(encode::branch(5, handler_register, 0, 20));
    emit(encode::store(2, 0, bus_base, 0x100));
    emit(encode::csr(2, handler_second, 0x344, 0));
    emit(encode::branch(1, handler_second, 0, -8));
    emit(encode::jump_and_link(0, 40));
    emit(encode::csr(2, handler_register, mepc, 0));
    emit(encode::load(5, handler_second, handler_register, 0));
    emit(encode::operation_immediate(7, handler_second, handler_second, 3));
    emit(encode::add_immediate(handler_second, handler_second, -3));
    emit(encode::add_immediate(handler_register, handler_register, 2));
    emit(encode::branch(1, handler_second, 0, 8));
    emit(encode::add_immediate(handler_register, handler_register, 2));
    emit(encode::csr(1, 0, mepc, handler_register));
    emit(encode::csr(2, handler_second, 0x343, 0));
    emit(encode::trap_return());
    load_constant(handler_register, 0x80000004);
    emit(encode::csr(1, 0, mtvec, handler_register));
    load_constant(tohost_base, random_program_tohost);
    load_constant(bus_base, settings_.portable ? nowhere : TestDevice::base);
    load_constant(data_base, data_address);
    load_constant(short_data_base, short_data_address);
    for (Word index = 1; index <= 28; ++index) {
      if (index != short_data_base) load_constant(index, interesting_value());
    }
    load_constant(1, settings_.passes);
    emit(encode::store(2, 1, tohost_base, passes_offset));
    while (program_.size() < instructions_of_prologue - 2) emit(encode::nop());
  }

  Word interesting_value() {
    constexpr std::array<Word, 8> values{0,          1,          0xFFFFFFFF, 0x80000000,
                                         0x7FFFFFFF, 0x55555555, 0xFFFF,     2};
    return one_in(2) ? values[below(values.size())] : static_cast<Word>(random_());
  }

  void add_instruction() {
    if (below(1000) < settings_.wild_per_mille) return emit(wild_word());
    switch (below(settings_.interrupts ? 22 : 20)) {
      case 0:
      case 1:
      case 2:
      case 3:
        return add_operation();
      case 4:
      case 5:
      case 6:
        return add_immediate_operation();
      case 7:
        return emit(one_in(2) ? encode::load_upper(destination(), interesting_value())
                              : encode::add_upper_to_pc(destination(), interesting_value()));
      case 8:
      case 9:
      case 10:
        return emit(encode::operation(below(8), 1, destination(), source(), source()));
      case 11:
      case 12:
      case 13:
        return add_load();
      case 14:
      case 15:
        return add_store();
      case 16:
      case 17:
        return add_branch();
      case 18:
        return add_jump();
      default:
        return add_system();
    }
  }

  void add_bit_manipulation() {
    const Word rd = destination(), first = source(), second = source();
    switch (below(11)) {
      case 0:
        return emit(encode::leading_zeros(rd, first));
      case 1:
        return emit(encode::trailing_zeros(rd, first));
      case 2:
        return emit(encode::population(rd, first));
      case 3:
        return emit(encode::extend_byte(rd, first));
      case 4:
        return emit(one_in(2) ? encode::extend_half_word(rd, first)
                              : encode::zero_extend_half_word(rd, first));
      case 5:
        return emit(encode::combine_bytes(rd, first));
      case 6:
        return emit(encode::reverse_bytes(rd, first));
      case 7:
        return emit(encode::rotate_right(rd, first, below(32)));
      case 8:
        return emit(encode::operation(one_in(2) ? 1 : 5, 0x30, rd, first, second));
      case 9:
        return emit(encode::operation(4 + below(4), 5, rd, first, second));
      default: {
        constexpr std::array<Word, 3> inverting{4, 6, 7};
        return emit(encode::operation(inverting[below(3)], 0x20, rd, first, second));
      }
    }
  }

  void add_operation() {
    if (settings_.zbb && one_in(2)) return add_bit_manipulation();
    const Word funct3 = below(8);
    const bool alternate = (funct3 == 0 || funct3 == 5) && one_in(2);
    emit(encode::operation(funct3, alternate ? 0x20 : 0, destination(), source(), source()));
  }

  void add_immediate_operation() {
    const Word funct3 = below(8);
    std::int32_t immediate = small_immediate();
    if (funct3 == 1) immediate &= 31;
    if (funct3 == 5) immediate &= 0x41F;
    emit(encode::operation_immediate(funct3, destination(), source(), immediate));
  }

  // Mostly a place in memory, sometimes on the bus, rarely misaligned or where nothing answers.
  std::pair<Word, std::int32_t> place(Word size) {
    std::int32_t offset = static_cast<std::int32_t>(below(256)) - 128;
    if (settings_.portable || !one_in(12)) offset &= -static_cast<std::int32_t>(1u << size);
    if (!one_in(6)) return {data_base, offset};
    return {bus_base, one_in(5) ? offset + 0x400 : (offset & 0xFF)};
  }

  void add_load() {
    constexpr std::array<Word, 5> kinds{0, 1, 2, 4, 5};
    const Word funct3 = kinds[below(kinds.size())];
    const auto [base, offset] = place(funct3 & 3);
    emit(encode::load(funct3, destination(), base, offset));
  }

  void add_store() {
    const Word funct3 = below(3);
    const auto [base, offset] = place(funct3);
    emit(encode::store(funct3, source(), base, offset));
  }

  // A little ahead; no jump may lead between the instructions of a computed jump to there.
  std::size_t target_ahead() {
    const std::size_t target = program_.size() + 1 + below(8);
    targets_.insert(target);
    return target;
  }

  bool is_target(std::size_t first, std::size_t last) const {
    const auto found = targets_.lower_bound(first);
    return found != targets_.end() && *found <= last;
  }

  void add_branch() {
    constexpr std::array<Word, 6> kinds{0, 1, 4, 5, 6, 7};
    const Word kind = kinds[below(kinds.size())], first = source(), second = source();
    program_.add_distance(program_.size(), target_ahead(), [=](std::int32_t bytes) {
      return encode::branch(kind, first, second, bytes);
    });
  }

  void add_jump() {
    const Word rd = one_in(4) ? jump_base : destination();
    const std::size_t here = program_.size();
    if (one_in(2) || is_target(here + 1, here + 2)) {
      return program_.add_distance(here, target_ahead(), [=](std::int32_t bytes) {
        return encode::jump_and_link(rd, bytes);
      });
    }
    emit(encode::add_upper_to_pc(jump_base, 0));
    const std::int32_t odd = one_in(4) ? 1 : 0;
    if (one_in(2)) {
      return program_.add_distance(here, target_ahead(), [=](std::int32_t bytes) {
        return encode::jump_and_link_register(rd, jump_base, bytes + odd);
      });
    }
    const std::size_t target = target_ahead() + 1;
    targets_.insert(target);
    program_.add_distance(here, target, [=](std::int32_t bytes) {
      return encode::add_immediate(jump_base, jump_base, bytes + odd);
    });
    emit(one_in(2) ? compressed::jump_register(jump_base)
                   : compressed::jump_and_link_register(jump_base));
  }

  void add_short_instruction() {
    if (below(1000) < settings_.wild_per_mille) return emit(wild_half_word());
    const std::int32_t nonzero = 1 + static_cast<std::int32_t>(below(31));
    switch (below(16)) {
      case 0:
        return emit(compressed::add_immediate(destination(), tiny_immediate()));
      case 1:
        return emit(compressed::load_immediate(destination(), tiny_immediate()));
      case 2:
        return emit(compressed::load_upper(destination(), one_in(2) ? nonzero : -nonzero));
      case 3:
        return emit(compressed::shift_left(destination(), nonzero));
      case 4:
      case 5:
        return emit(compressed::short_immediate(below(2), short_destination(), nonzero));
      case 6:
        return emit(compressed::short_immediate(2, short_destination(), tiny_immediate()));
      case 7:
      case 8:
        return emit(compressed::short_operation(below(4), short_destination(), short_source()));
      case 9:
        return emit(compressed::move(destination(), 1 + below(25)));
      case 10:
        return emit(compressed::add(destination(), 1 + below(25)));
      case 11:
        return emit(compressed::address_from_sp(short_destination(), 4 * nonzero * 8));
      case 12:
        return add_short_load();
      case 13:
        return add_short_store();
      case 14:
        return add_short_jump();
      default:
        return add_stack_move();
    }
  }

  // There and back: the stack pointer stays where its data are, whatever jumps in between.
  void add_stack_move() {
    if (one_in(8)) return emit(compressed::breakpoint());
    const std::int32_t amount = 16 * (1 + static_cast<std::int32_t>(below(2)));
    emit(compressed::add_to_sp(amount));
    emit(compressed::add_to_sp(-amount));
  }

  void add_short_load() {
    if (one_in(2)) {
      const Word rd = destination();
      return emit(
          compressed::load_from_sp(rd == 0 ? 1 : rd, 4 * static_cast<std::int32_t>(below(64))));
    }
    emit(compressed::load(short_destination(), short_data_base,
                          4 * static_cast<std::int32_t>(below(32))));
  }

  void add_short_store() {
    if (one_in(2)) {
      return emit(compressed::store_to_sp(source(), 4 * static_cast<std::int32_t>(below(64))));
    }
    emit(compressed::store(short_source(), short_data_base,
                           4 * static_cast<std::int32_t>(below(32))));
  }

  void add_short_jump() {
    const std::size_t here = program_.size(), target = target_ahead();
    if (one_in(2)) {
      const Word rs1 = short_source();
      const bool not_zero = one_in(2);
      return program_.add_distance(here, target, [=](std::int32_t bytes) {
        return compressed::branch(not_zero, rs1, bytes);
      });
    }
    const Word kind = one_in(2) ? 1 : 5;
    program_.add_distance(here, target,
                          [=](std::int32_t bytes) { return compressed::jump_type(kind, bytes); });
  }

  void add_system() {
    switch (below(settings_.interrupts ? 9 : 6)) {
      case 0:
        return emit(encode::environment_call());
      case 1:
        return emit(encode::breakpoint());
      case 2:
        return emit(one_in(2) ? encode::fence() : encode::fence_i());
      case 3:
      case 4:
      case 5:
        return add_csr();
      case 6:
        return emit(encode::store(2, source(), bus_base, 0x100));
      case 7:
        return emit(encode::csr(one_in(4) ? 1 : 2, destination(), mie, source()));
      default:
        return emit(encode::csr(one_in(4) ? 7 : 6, destination(), mstatus, 8));
    }
  }

  void add_csr() {
    if (settings_.portable) return add_portable_csr();
    constexpr std::array<Word, 24> addresses{
        0x300, 0x301, 0x310, 0x320, 0x340, 0x340, 0x340, 0x341, 0x342, 0x343, 0x344, 0x7A0,
        0xB00, 0xB02, 0xB82, 0xB03, 0x323, 0xC00, 0xC02, 0xC82, 0xF11, 0xF14, 0x180, 0x3A0};
    const Word kind = 1 + below(3);
    const Word address = one_in(10) ? below(4096) : addresses[below(addresses.size())];
    // The handler must stay where it is; interrupts are switched on only where they are wanted.
    const bool keep =
        address == mtvec || (!settings_.interrupts && (address == mie || address == mstatus));
    if (keep) return emit(encode::csr(2, destination(), address, 0));
    emit(encode::csr(one_in(3) ? kind + 4 : kind, destination(), address, source()));
  }

  // Of the last: one that does not exist, and one that cannot be written.
  void add_portable_csr() {
    constexpr std::array<Word, 7> addresses{0x340, 0x340, 0x341, 0x343, 0x301, 0x7C0, 0xF14};
    const Word address = addresses[below(addresses.size())];
    const Word kind = address == 0x301 ? 2 : 1 + below(3);
    const bool from_constant = one_in(3);
    const Word operand = address == 0x301 ? 0 : source();
    if (address == mepc) return add_even_write_of_mepc(kind, from_constant, operand);
    emit(encode::csr(from_constant ? kind + 4 : kind, destination(), address, operand));
  }

  // QEMU 10.0 keeps bit 0 of what is written to mepc, and reads it back: there it is 0.
  void add_even_write_of_mepc(Word kind, bool from_constant, Word operand) {
    constexpr Word clear = 3;
    if (from_constant) {
      emit(encode::csr(kind + 4, destination(), mepc, operand & ~Word{1}));
    } else if (one_in(2)) {
      emit(encode::csr(clear, destination(), mepc, operand));
    } else {
      emit(encode::csr(kind, destination(), mepc, data_base));
    }
  }

  Word wild_word() {
    while (true) {
      auto word = static_cast<Word>(random_());
      word |= 3;
      const Word opcode = word & 0x7F, rd = word >> 7 & 31;
      const bool moves = opcode == 0x6F || opcode == 0x67 || opcode == 0x63 || opcode == 0x23;
      const bool system =
          opcode == 0x73 &&
          (word >> 20 == mtvec || word == encode::wait_for_interrupt() ||
           word == encode::trap_return() || word >> 20 == mie || word >> 20 == mstatus);
      const bool portable = opcode != 0x73 && opcode != 0x03;
      if (!moves && !system && (portable || !settings_.portable) && rd < 26 &&
          rd != stack_pointer && rd != short_data_base)
        return word;
    }
  }

  Word wild_half_word() {
    while (true) {
      const Word half_word = below(0x10000);
      const Word quadrant = half_word & 3, funct3 = half_word >> 13, rd = half_word >> 7 & 31;
      const Word short_rd = 8 + (quadrant == 0 ? half_word >> 2 & 7 : half_word >> 7 & 7);
      const bool is_short = quadrant == 0 || (quadrant == 1 && funct3 == 4);
      const bool moves = (quadrant != 1 && funct3 == 6) ||
                         (quadrant == 1 && (funct3 % 4 == 1 || funct3 >= 6)) ||
                         (quadrant == 2 && funct3 == 4 && (half_word >> 2 & 31) == 0 && rd != 0);
      const Word written = is_short ? short_rd : rd;
      const bool portable = quadrant != 0 || funct3 != 2;
      if (quadrant != 3 && !moves && (portable || !settings_.portable) && written < 26 &&
          written != stack_pointer && written != short_data_base) {
        return half_word;
      }
    }
  }

  std::mt19937 random_;
  RandomProgramSettings settings_;
  ProgramBuilder program_;
  std::set<std::size_t> targets_;
};

}  // namespace

std::vector<std::uint8_t> random_program(std::uint32_t seed,
                                         const RandomProgramSettings& settings) {
  return Generator(seed, settings).generate();
}

}  // namespace processor
