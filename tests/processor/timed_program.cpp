// SPDX-License-Identifier: Apache-2.0
// Start-up, handler, and a loop of random pieces.
#include "tests/processor/timed_program.hpp"

#include <random>

#include "tests/processor/chip.hpp"
#include "tests/processor/encode_compressed.hpp"
#include "tests/processor/program_builder.hpp"
#include "tests/processor/timing_kinds.hpp"

namespace processor {
namespace {

using encode::Word;
using namespace timed;
namespace compressed = encode::compressed;

constexpr Word mstatus = 0x300, mie = 0x304, mtvec = 0x305, mepc = 0x341, mcause = 0x342,
               mip = 0x344;
constexpr Word scratch = 20, second_scratch = 21, upper_half_of_mret = 22, all_ones = 23;
constexpr Word nothing_answers = 0x200;  // from bus_base

class TimedProgram {
 public:
  explicit TimedProgram(std::uint32_t seed) : random_(seed) {}

  std::vector<std::uint8_t> image() {
    constexpr std::size_t pieces = 400;
    program_.add_distance(0, instructions_of_handler + 1,
                          [](std::int32_t bytes) { return encode::jump_and_link(0, bytes); });
    add_handler();
    add_start_up();
    const std::size_t loop = program_.size();
    for (std::size_t count = 0; count < pieces; ++count) add_piece();
    program_.add_distance(program_.size(), loop,
                          [](std::int32_t bytes) { return encode::jump_and_link(0, bytes); });
    return program_.image();
  }

 private:
  static constexpr std::size_t instructions_of_handler = 21;

  Word below(Word limit) { return static_cast<Word>(random_()) % limit; }
  void emit(Word instruction) { program_.add(instruction); }

  // Interrupts: the device is made quiet; a return in whose place it was taken is left out, since
  // its target is lost. Exceptions: the instruction is left out.
  void add_handler() {
    emit(encode::csr(2, scratch, mcause, 0));
    emit(encode::branch(5, scratch, 0, 44));
    emit(encode::store(2, 0, bus_base, 0x100));
    emit(encode::csr(2, second_scratch, mip, 0));
    emit(encode::branch(1, second_scratch, 0, -8));
    emit(encode::csr(2, scratch, mepc, 0));
    emit(encode::load(5, second_scratch, scratch, 2));
    emit(encode::branch(1, second_scratch, upper_half_of_mret, 12));
    emit(encode::add_immediate(scratch, scratch, 4));
    emit(encode::csr(1, 0, mepc, scratch));
    emit(encode::jump_and_link(0, 40));
    emit(encode::nop());
    emit(encode::csr(2, scratch, mepc, 0));
    emit(encode::load(5, second_scratch, scratch, 0));
    emit(encode::operation_immediate(7, second_scratch, second_scratch, 3));
    emit(encode::add_immediate(second_scratch, second_scratch, -3));
    emit(encode::add_immediate(scratch, scratch, 2));
    emit(encode::branch(1, second_scratch, 0, 8));
    emit(encode::add_immediate(scratch, scratch, 2));
    emit(encode::csr(1, 0, mepc, scratch));
    emit(encode::trap_return());
  }

  void add_start_up() {
    emit(encode::load_upper(place_address, Chip::memory_base));
    emit(encode::add_immediate(place_address, place_address, 4));
    emit(encode::csr(1, 0, mtvec, place_address));
    emit(encode::load_upper(data_base, 0x8000C000));
    emit(encode::load_upper(bus_base, 0xF0000000));
    emit(encode::add_immediate(short_data_base, data_base, 64));
    emit(encode::add_immediate(stack_pointer, data_base, 128));
    emit(encode::load_upper(upper_half_of_mret, 0x3000));
    emit(encode::add_immediate(upper_half_of_mret, upper_half_of_mret, 0x20));
    emit(encode::add_immediate(4, 0, -77));
    emit(encode::add_immediate(3, 0, 5));
    emit(encode::add_immediate(all_ones, 0, -1));
    emit(encode::csr(1, 0, mie, all_ones));
    emit(encode::csr(6, 0, mstatus, 8));
  }

  // The address of the instruction so many bytes further on.
  void add_place(std::int32_t bytes) {
    emit(encode::add_upper_to_pc(place_address, 0));
    emit(encode::add_immediate(place_address, place_address, bytes));
  }

  void add_piece() {
    switch (below(14)) {
      case 0: {  // To after the return, perhaps with interrupts off up to it.
        if (below(2) == 0) emit(encode::csr(7, 0, mstatus, 8));
        emit(encode::add_immediate(scratch, 0, 0x80));
        emit(encode::csr(2, 0, mstatus, scratch));
        add_place(16);
        emit(encode::csr(1, 0, mepc, place_address));
        emit(encode::trap_return());
        return;
      }
      case 1:
        for (Word count = below(5); count > 0; --count) emit(encode::wait_for_interrupt());
        return;
      case 2:  // Without interrupts: what wakes is taken later.
        emit(encode::csr(7, 0, mstatus, 8));
        for (Word count = below(4); count > 0; --count) emit(encode::wait_for_interrupt());
        add_kind();
        emit(encode::csr(6, 0, mstatus, 8));
        return;
      case 3:  // Masked, and let through again.
        emit(encode::csr(1, 0, mie, 0));
        add_kind();
        emit(encode::csr(1, 0, mie, all_ones));
        return;
      case 4:
        add_place(12 + 2 * static_cast<std::int32_t>(below(2)));
        emit(encode::jump_and_link_register(below(2), place_address, 0));
        emit(compressed::nop());
        return;
      case 5:  // A loop of a few rounds.
        emit(encode::add_immediate(5, 0, static_cast<std::int32_t>(1 + below(3))));
        emit(encode::add_immediate(5, 5, -1));
        emit(encode::branch(below(2) == 0 ? 1 : 6, 0, 5, -4));
        return;
      case 6:
        emit(below(2) == 0 ? encode::load(2, late_result, bus_base, nothing_answers)
                           : encode::store(2, late_result, bus_base, nothing_answers));
        return;
      case 7:
        emit(below(2) == 0 ? encode::operation(0, 0, 1, late_result, 3)
                           : encode::operation(4, 1, late_result, 3, late_result));
        return;
      case 8:
        emit(encode::branch(below(8) & 5, below(5), below(5), 6));
        emit(compressed::nop());
        return;
      default:
        return add_kind();
    }
  }

  void add_kind() {
    const auto& kinds = kinds_of_instructions();
    const Kind& kind = kinds[below(static_cast<Word>(kinds.size()))];
    const bool needs_its_place =
        kind.row == std::string("mret") || kind.row == std::string("jump to a register");
    emit(needs_its_place ? encode::nop() : kind.word);
  }

  std::mt19937 random_;
  ProgramBuilder program_;
};

}  // namespace

std::vector<std::uint8_t> timed_program(std::uint32_t seed) { return TimedProgram(seed).image(); }

}  // namespace processor
