// SPDX-License-Identifier: Apache-2.0
// The processor with its memory, without its netlist: what each instruction does, and the clock in
// which it does it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "sim/processor/decoder.hpp"
#include "sim/processor/machine_state.hpp"

namespace processor {

// An access of the bus: byte address, byte lanes, data in its lanes.
struct BusAccess {
  std::uint32_t address{};
  std::uint32_t data{};
  std::uint8_t lanes{};
  bool write{};
};

// Clock n is the time before rising edge n, and what happens in it is there after this edge.
//
// The model runs ahead of the rest of the chip: run() assumes that the interrupt lines stay as they
// are. If set_interrupts() later reports a change, execution since the last mark() is rolled back
// and repeated.
class ProcessorModel {
 public:
  static constexpr std::uint32_t memory_start = 0x8000'0000;

  // A multiple of 4 bytes, all 0.
  ProcessorModel(std::uint32_t memory_bytes, bool has_zbb);

  // `released`: the first clock in which the processor is not in reset. The memory and the
  // registers stay as they are.
  void reset(Clock released);

  // Executes all that is complete by `limit` or earlier. Returns the last clock up to which that
  // is so: less than `limit` where the list of stores that could be taken back is full. Stops at
  // an access of the bus and goes on when that is complete.
  Clock run(Clock limit);
  // What the last run() returned, or less after a rollback.
  Clock complete() const { return complete_; }

  // An access waits for, or is under way since, its clock: request from the edge of that clock on.
  bool accesses() const { return state_.accesses; }
  Clock access_clock() const { return state_.access_clock; }
  const BusAccess& access() const { return access_; }
  // The clock in which the response is seen; with the word of a load, in its lanes.
  void complete_access(Clock clock, bool is_refused, std::uint32_t word);

  // The lines have this level (in the bits of mip) from the clock behind edge `now` on.
  void set_interrupts(Clock now, std::uint32_t lines);
  // An interrupt could be taken if its line rose.
  bool interrupts_matter() const { return state_.interrupt_enable; }

  // Nothing before this point is rolled back any more.
  void mark();
  // To this clock, forward or back; back not beyond the last mark().
  void bring_to(Clock clock);

  // Of the model as far as it has run. Throws std::out_of_range outside the memory.
  std::uint32_t read_memory(std::uint32_t address) const;
  void write_memory(std::uint32_t address, std::uint32_t word);

  // Since the model was made; of a sleep that goes on, up to edge `now`.
  std::uint64_t instructions() const { return state_.instructions; }
  std::uint64_t traps() const { return state_.traps; }
  std::uint64_t sleeping_clocks(Clock now) const;

  const MachineState& state() const { return state_; }

 private:
  struct Store {
    std::uint32_t place;
    std::uint32_t word;
  };

  struct Change {
    Clock now;
    std::uint32_t lines;
    Clock seen;
  };

  static constexpr std::size_t most_stores = 4096;
  static constexpr unsigned code_block_shift = 6;

  bool interrupt_is_due() const {
    return state_.interrupt_enable && (state_.lines & state_.interrupts_enabled) != 0;
  }
  void take_back(Clock clock);
  Clock run_with_these_lines(Clock limit);
  void apply_change();
  // As far as no interrupt is taken. `single`: one instruction. Returns false if it cannot
  // continue now.
  template <bool single>
  bool execute(Clock limit);
  bool sleep(Clock limit);
  bool take_interrupt(Clock limit);
  Clock last_open_clock();
  const Instruction& decoded_at(std::uint32_t place);
  void trap(std::uint32_t cause, std::uint32_t value, Clock clock);
  void begin_access(const Instruction& instruction, std::uint32_t address, Clock clock);

  enum class CsrResult : std::uint8_t { done, illegal, too_early };
  CsrResult execute_csr(const Instruction& instruction, Clock clock);
  bool read_csr(std::uint32_t number, Clock clock, std::uint32_t& value) const;
  void write_csr(std::uint32_t number, std::uint32_t value, Clock clock);

  std::uint32_t word_at(std::uint32_t place) const;
  void put_word(std::uint32_t place, std::uint32_t word);
  template <class Value>
  bool store(std::uint32_t place, std::uint32_t value);
  void forget_code(std::uint32_t place, unsigned bytes);

  std::vector<std::uint8_t> memory_;
  std::uint32_t size_;
  bool has_zbb_;
  // For each half word of the memory; and which blocks of the memory hold some.
  std::vector<Instruction> decoded_;
  std::vector<std::uint8_t> holds_code_;

  MachineState state_;
  BusAccess access_;
  Instruction accessing_;
  // What take_back() needs. `sensitive_`: since the mark the level of a line has mattered.
  // `change_`: of the lines, with the mark; it waits for the next run.
  MachineState marked_;
  Clock marked_complete_ = 0;
  std::optional<Change> change_;
  bool change_waits_ = false;
  std::array<Store, most_stores> stores_{};
  std::size_t stored_ = 0;
  bool sensitive_ = false;
  bool full_ = false;
  // The last clock whose level is known for a read of mip.
  Clock lines_known_ = std::numeric_limits<Clock>::max();
  Clock complete_ = 0;  // all that is complete up to here has been executed
};

}  // namespace processor
