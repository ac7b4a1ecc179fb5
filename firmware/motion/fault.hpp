// SPDX-License-Identifier: Apache-2.0
// Errors of motion planning and homing, and their messages.
#pragma once

#include <cstdint>
#include <string_view>

namespace motion {

enum class Fault : std::uint8_t {
  steps_per_meter_out_of_range,
  speed_out_of_range,
  acceleration_out_of_range,
  jerk_out_of_range,
  junction_deviation_out_of_range,
  length_out_of_range,
  feedrate_out_of_range,
  target_out_of_range,
  target_out_of_reach,
  mesh_out_of_reach,
  not_homed,
  line_too_long,
  queue_full,
  arc_without_radius,
  arc_too_large,
  arc_end_off_circle,
  arc_ends_too_far_apart,
  end_stop_not_found,
  end_stop_stuck,
};

std::string_view describe(Fault fault);

}  // namespace motion
