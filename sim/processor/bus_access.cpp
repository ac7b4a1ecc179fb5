// SPDX-License-Identifier: Apache-2.0
// Loads and stores outside the memory.
#include <algorithm>
#include <array>

#include "sim/processor/processor_model.hpp"

namespace processor {

void ProcessorModel::begin_access(const Instruction& instruction, std::uint32_t address,
                                  Clock clock) {
  accessing_ = instruction;
  const bool writes = is_store(instruction.operation);
  // After the three signed loads come the two unsigned ones.
  const auto size = writes ? static_cast<unsigned>(instruction.operation) -
                                 static_cast<unsigned>(Operation::store_byte)
                           : (static_cast<unsigned>(instruction.operation) -
                              static_cast<unsigned>(Operation::load_byte)) %
                                 3;
  const unsigned bytes = 1U << size;
  constexpr std::array<std::uint32_t, 3> copies{0x0101'0101, 0x0001'0001, 1};
  // With a load the lines of the data carry its second operand, the offset.
  const std::uint32_t data = writes ? state_.registers[instruction.second] : instruction.immediate;
  const std::uint32_t mask = bytes == 4 ? ~std::uint32_t{0} : (1U << (8 * bytes)) - 1;
  access_ = {.address = address,
             .data = (data & mask) * copies[size],
             .lanes = static_cast<std::uint8_t>(((1U << bytes) - 1) << (address & 3)),
             .write = writes};
  state_.accesses = true;
  state_.access_clock = clock;
}

void ProcessorModel::complete_access(Clock clock, bool is_refused, std::uint32_t word) {
  constexpr std::uint32_t load_access = 5, store_access = 7;
  if (change_waits_) apply_change();
  state_.accesses = false;
  if (is_refused) {
    trap(access_.write ? store_access : load_access, access_.address, clock);
  } else {
    const std::uint32_t value = word >> (8 * (access_.address & 3));
    std::uint32_t loaded = value;
    switch (accessing_.operation) {
      case Operation::load_byte:
        loaded = static_cast<std::uint32_t>(static_cast<std::int8_t>(value));
        break;
      case Operation::load_half:
        loaded = static_cast<std::uint32_t>(static_cast<std::int16_t>(value));
        break;
      case Operation::load_unsigned_byte:
        loaded = value & 0xff;
        break;
      case Operation::load_unsigned_half:
        loaded = value & 0xffff;
        break;
      default:
        break;
    }
    state_.late_register = no_register;
    if (!access_.write) {
      state_.registers[accessing_.destination] = loaded;
      state_.late_register = accessing_.destination;
    }
    ++state_.instructions;
    state_.program_counter += accessing_.bytes;
    state_.begins = clock + 1;
    state_.open_from = std::max(state_.open_from, clock + 1);
  }
  complete_ = clock;
  mark();
}

}  // namespace processor
