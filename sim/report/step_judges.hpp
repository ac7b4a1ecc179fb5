// SPDX-License-Identifier: Apache-2.0
// The two judges of the steps, of which one judges at a time.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/report/plain_check.hpp"
#include "sim/report/shaped_check.hpp"

namespace report {

class StepJudges {
 public:
  StepJudges(const MachineState& start, double clock_hz, double fastest_mm_s)
      : plain_(start), shaped_(clock_hz, fastest_mm_s) {}

  // The one for what the motors make now.
  StepJudge& now() {
    if (shaping_.any()) return shaped_;
    return plain_;
  }
  // From rest.
  void set_shaping(const ShapingSetting& setting) {
    shaping_ = setting;
    shaped_.set_shaping(setting);
  }
  const ShapingSetting& shaping() const { return shaping_; }
  void set_grid(const MotorGrid& grid) {
    plain_.set_grid(grid);
    shaped_.set_grid(grid);
  }
  void set_play_mm(double play_mm) { plain_.set_play_mm(play_mm); }

  bool nothing_open() const { return plain_.nothing_open() && shaped_.nothing_open(); }
  std::uint64_t reached() const { return plain_.reached() + shaped_.reached(); }
  Steps unasked_steps() const {
    Steps steps = plain_.unasked_steps();
    for (std::size_t i = 0; i < steps.size(); ++i) steps[i] += shaped_.unasked_steps()[i];
    return steps;
  }
  const PathCheck& path() const { return plain_.path(); }
  const ShapedCheck& shaped() const { return shaped_; }

 private:
  ShapingSetting shaping_;
  PlainCheck plain_;
  ShapedCheck shaped_;
};

}  // namespace report
