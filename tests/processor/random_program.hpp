// SPDX-License-Identifier: Apache-2.0
// Makes programs of random instructions that end: forward jumps only, traps skip what raised them.
#pragma once

#include <cstdint>
#include <vector>

namespace processor {

struct RandomProgramSettings {
  unsigned length = 1000;
  // Of 1000 instructions, so many are words that may be anything but a jump or a store.
  unsigned wild_per_mille = 30;
  bool interrupts = true;
  // Only what every processor of this architecture does alike: no misaligned data, no peripherals,
  // no registers whose contents are free.
  bool portable = false;
  // With the instructions of Zbb.
  bool zbb = false;
  // How often the random part is run, each time with the values that the time before has left.
  unsigned passes = 1;
};

// The address at which it stores 1 when it has ended.
inline constexpr std::uint32_t random_program_tohost = 0x8000FFF0;

std::vector<std::uint8_t> random_program(std::uint32_t seed, const RandomProgramSettings& settings);

}  // namespace processor
