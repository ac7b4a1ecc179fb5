// SPDX-License-Identifier: Apache-2.0
// Distinguishes a host that has hung up from noise: the line was low for a whole frame, and
// then idle.
#pragma once

#include <cstdint>

#include "drivers/uart.hpp"
#include "units/quantity.hpp"

namespace application {

class HangUp {
 public:
  // Much longer than a host pauses in the middle of a line.
  static constexpr units::Milliseconds least_rest{10};

  // After each look at the uart, whose counts are `errors`: `gap` where something was lost before
  // the last byte that came, `emptied` where no byte is left. True once for each hang-up.
  bool seen(const drivers::UartErrorCounts& errors, bool gap, bool emptied,
            units::Milliseconds now) {
    if (gap) pending_ = false;
    if (errors.breaks != breaks_) {
      breaks_ = errors.breaks;
      break_at_ = now;
      pending_ = !gap;
    }
    if (!pending_ || !emptied || now - break_at_ < least_rest) return false;
    pending_ = false;
    known_ = true;
    lost_ = lost(errors);
    return true;
  }

  // Whether nothing was lost before the marked byte but what a hang-up explains.
  bool explains(const drivers::UartErrorCounts& errors) {
    const bool explained = known_ && lost_ == lost(errors);
    known_ = false;
    return explained;
  }

 private:
  static std::uint16_t lost(const drivers::UartErrorCounts& errors) {
    return static_cast<std::uint16_t>(errors.overruns + errors.framing_errors + errors.breaks);
  }

  units::Milliseconds break_at_{};
  std::uint16_t breaks_{};
  std::uint16_t lost_{};
  bool pending_{};
  bool known_{};
};

}  // namespace application
