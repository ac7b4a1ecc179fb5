// SPDX-License-Identifier: Apache-2.0
// The whole firmware on the fake chip, in a state that is prepared once, and what must hold of the
// printer whatever a host says.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "tests/application/fake_chip.hpp"

namespace fuzz {

// What the printer has come to before the input begins.
enum class Prepared : std::uint8_t { started, homed, hot, nearly_too_hot };
inline constexpr std::size_t prepared_states = 4;

class PrinterModel {
 public:
  // All of them share the firmware's memory: one at a time.
  explicit PrinterModel(Prepared state);

  application_test::FakeChip& chip();
  // One pass of the firmware's loop, and the sleep that it ends with; what must hold is checked.
  void pass();
  void run(double seconds);
  // The next whole line from the firmware.
  std::optional<std::string> reply();
  bool halted() const;
  double seconds() const;
  // Steps per millimetre have been changed: the travel in steps is another.
  void forget_travel() { travel_known_ = false; }
  // Once more, and what holds only at the end.
  void check_at_the_end();

 private:
  void check();
  void check_reply(std::string_view line);
  void check_target(std::string_view line, std::string_view name, double max_c);

  bool travel_known_;
  std::array<std::uint64_t, 2> too_hot_since_{};
};

}  // namespace fuzz
