// SPDX-License-Identifier: Apache-2.0
// Reference: what a stop, an emergency and the watchdog do.
#include "tests/motion_reference/step_generator_reference.hpp"

namespace motion_reference {
namespace {

constexpr std::uint32_t emergency_bit = 0x100;

}  // namespace

void StepGeneratorReference::begin_stop() {
  stopped_ = true;
  braking_ = false;
  base_.reset();
  phase_ = 0;
  forget_queue();
}

void StepGeneratorReference::cut_motors_off(bool stopped) {
  if (!stopped) motors_cut_ = false;
  if ((inputs_ & emergency_bit) == 0) return;
  motors_ = 0;
  motors_cut_ = positions_lost_ = true;
}

void StepGeneratorReference::watch(bool moving, bool fed) {
  watchdog_expired_ = false;
  if (fed || !moving) {
    unheard_ = 0;
  } else if (watchdog_limit_ != 0) {
    ++unheard_;
    watchdog_expired_ = unheard_ >= watchdog_limit_;
  }
}

void StepGeneratorReference::forget_queue() {
  queue_.clear();
  draft_.forget();
  line_left_ = 0;
}

}  // namespace motion_reference
