// SPDX-License-Identifier: Apache-2.0
// What every judge of the steps can do, with input shaping or without it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/report/gcode_path.hpp"
#include "sim/simulation/pins.hpp"

namespace report {

class MotorGrid;

using Steps = std::array<std::int64_t, motor_count>;  // mechanical

struct RequestedLine {
  std::size_t file_line{};
  std::string text;
};

// Where the machine stood, and how many steps each axis had made until then, both ways.
struct MachineState {
  sim::Clock clock{};
  Steps position{};
  Steps steps_made{};
};

struct UnreachedPoint {
  RequestedLine line;
  Steps target{};
  MachineState nearest;  // of all states in which it could have been reached
};

class StepJudge {
 public:
  virtual ~StepJudge() = default;

  virtual void set_grid(const MotorGrid& grid) = 0;

  // The file requests this move, from now on, which ends at `target`. `other`: as good as that.
  virtual void ask(const Move& move, RequestedLine line, const Steps& target,
                   const std::optional<Steps>& other) = 0;
  // The machine's present position.
  virtual void at(const MachineState& state) = 0;
  // The axes move on otherwise as soon as they have come to the end of the last line.
  virtual void end_freely() = 0;
  // Everything requested must have been made: what was not reached is missed. Where the machine is
  // said to rest since then, the last point is missed too unless it stands there.
  virtual void settle(bool rests) = 0;
  // Nothing more comes, but lines may have been under way: they are neither reached nor missed.
  virtual void abandon() = 0;
  // The machine has been moved here by something other than lines.
  virtual void restart(const MachineState& here, const Steps& meant) = 0;

  // Whether no line was under way then, a time after the last state; empty where no edge shows it.
  virtual std::optional<bool> rested_at(sim::Clock time) const = 0;
  // Every line requested is decided on, and the last one known to be made.
  virtual bool nothing_open() const = 0;
  virtual const Steps& last_target() const = 0;
  // Where it is to stand after the last line, or a place as good.
  virtual bool is_at_last_target(const Steps& position) const = 0;

  // So far.
  virtual std::uint64_t reached() const = 0;
  virtual const Steps& unasked_steps() const = 0;
  // Those that were missed since the last call.
  virtual std::vector<UnreachedPoint> take_missed() = 0;

 protected:
  StepJudge() = default;
  StepJudge(const StepJudge&) = default;
  StepJudge& operator=(const StepJudge&) = default;
};

}  // namespace report
