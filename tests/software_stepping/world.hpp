// SPDX-License-Identifier: Apache-2.0
// The chip around the stepper: a clock that goes on with each access, the timer, pins, end stops.
#pragma once

#include <cstdint>
#include <vector>

#include "software_stepping/stepper.hpp"
#include "tests/drivers/pulse_recorder.hpp"

namespace software_stepping_test {

struct World {
  std::uint64_t now{};
  std::uint64_t compare{~std::uint64_t{0}};
  std::uint32_t step{};
  std::uint32_t direction{};
  std::uint8_t triggered{};
  tests::PulseRecorder pulses;
  software_stepping::Tick tick;
  // Those that were made: the pins' raising edges, also of none.
  struct MadeTick {
    std::uint64_t clock{};
    std::uint32_t pins{}, direction{};
  };
  std::vector<MadeTick> ticks;
  std::uint32_t step_writes{};

  // The interrupts that come until then.
  void run(software_stepping::Stepper& stepper, std::uint64_t until);
};

// The one that the stepper under test reaches; each test makes its own.
World& world();
void make_world();

}  // namespace software_stepping_test
