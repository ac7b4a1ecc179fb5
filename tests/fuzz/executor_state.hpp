// SPDX-License-Identifier: Apache-2.0
// The firmware on the instant chip in states that are made once, and what can be seen of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "application/application.hpp"
#include "tests/fuzz/instant_chip.hpp"

namespace fuzz {

// What the printer has come to before an input begins.
enum class ExecutorState : std::uint8_t { started, homed, hot };
inline constexpr std::size_t executor_states = 3;

// Puts the firmware and its chip into the state. There is only one of both.
void restore(ExecutorState state);
const application::Application& executor_application();
// One pass of the loop, and so much time behind it if nothing more is to be done at once.
void pass_executor(std::uint32_t clocks);

inline constexpr std::array executor_heaters{application::Heater::hotend, application::Heater::bed};

// What a line that is rejected leaves as it is.
class Observation {
 public:
  // Takes the place of what was seen before.
  void look();
  // Since then.
  bool targets_have_changed() const;
  // By that line.
  void require_unchanged(std::string_view line) const;

 private:
  std::array<std::byte, sizeof(application::Coordinates)> coordinates_;
  std::array<std::byte, sizeof(motion::Limits)> limits_;
  application::Positions position_;
  std::array<units::Millicelsius, executor_heaters.size()> targets_;
  std::uint32_t fan_{};
  std::uint32_t motors_{};
  bool may_leave_travel_{};
};

}  // namespace fuzz
