// SPDX-License-Identifier: Apache-2.0
// What the plugin in QEMU writes before each instruction, and the test reads.
#pragma once

#include <array>
#include <cstdint>

namespace processor {

// In the byte order of this machine, without padding.
struct QemuRecord {
  static constexpr std::uint32_t mark = 0x51454d55;

  std::uint32_t begin = mark;  // distinguishes a record from messages of QEMU
  std::uint32_t program_counter = 0;
  // These two are read only where the instruction does not follow the last one in memory: after
  // jumps, taken branches and traps.
  std::uint32_t mtvec = 0;
  std::uint32_t mepc = 0;
  std::array<std::uint32_t, 32> registers{};
};
static_assert(sizeof(QemuRecord) == 36 * sizeof(std::uint32_t));

}  // namespace processor
