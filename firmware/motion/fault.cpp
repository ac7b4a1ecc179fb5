// SPDX-License-Identifier: Apache-2.0
// The texts of motion faults.
#include "motion/fault.hpp"

namespace motion {

std::string_view describe(Fault fault) {
  switch (fault) {
    case Fault::steps_per_meter_out_of_range:
      return "steps per unit out of range";
    case Fault::speed_out_of_range:
      return "speed out of range";
    case Fault::acceleration_out_of_range:
      return "acceleration out of range";
    case Fault::jerk_out_of_range:
      return "jerk out of range";
    case Fault::junction_deviation_out_of_range:
      return "junction deviation out of range";
    case Fault::length_out_of_range:
      return "length out of range";
    case Fault::feedrate_out_of_range:
      return "feedrate out of range";
    case Fault::target_out_of_range:
      return "target position out of range";
    case Fault::target_out_of_reach:
      return "target out of reach";
    case Fault::mesh_out_of_reach:
      return "out of reach above the mesh";
    case Fault::not_homed:
      return "home first";
    case Fault::line_too_long:
      return "move too long";
    case Fault::queue_full:
      return "move queue full";
    case Fault::arc_without_radius:
      return "arc without radius";
    case Fault::arc_too_large:
      return "arc with a radius above 10 m";
    case Fault::arc_end_off_circle:
      return "arc's end is not on its circle";
    case Fault::arc_ends_too_far_apart:
      return "arc's ends are farther apart than 2 R";
    case Fault::end_stop_not_found:
      return "end stop not found";
    case Fault::end_stop_stuck:
      return "end stop does not open";
  }
  return "unknown motion fault";
}

}  // namespace motion
