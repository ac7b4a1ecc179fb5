// SPDX-License-Identifier: Apache-2.0
// Input shaping and linear advance: M593, M900 and M572.
#pragma once

#include <cstddef>
#include <cstdint>

#include "application/active_command.hpp"
#include "application/motion_task.hpp"

namespace application {

// How many lines report them, and each: "echo: M593 X P"mzv" F40.00 D0.1000", ...,
// "echo: M900 K0.0500".
inline constexpr std::size_t shaping_reports = 3;
host_link::TextLine shaping_report(std::size_t index, const motion::ShapingSettings& settings);

class ShapingCommands {
 public:
  explicit ShapingCommands(MotionTask& motion) : motion_(motion) {}

  Progress set_shapers(ActiveCommand& command);
  // K of M900, S of M572.
  Progress set_advance(ActiveCommand& command);
  // Shapers for M593, otherwise linear advance.
  Progress report(ActiveCommand& command);

 private:
  // As soon as motion has come to rest.
  Progress set(ActiveCommand& command, const motion::ShapingSettings& settings,
               std::string_view reason);
  MotionTask& motion_;
};

}  // namespace application
