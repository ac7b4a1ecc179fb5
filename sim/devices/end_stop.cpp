// SPDX-License-Identifier: Apache-2.0
// The switch's position, and what a broken one does.
#include "sim/devices/end_stop.hpp"

namespace devices {

EndStop::EndStop(std::size_t axis, std::size_t input, sim::InputPins& inputs, std::int64_t position,
                 EndStopFault fault)
    : axis_(axis), input_(input), inputs_(inputs), fault_(fault) {
  set_position(position);
}

void EndStop::stepped(const StepEdge& edge) {
  if (edge.axis == axis_) {
    set_position(edge.position);
  }
}

void EndStop::set_position(std::int64_t position) {
  const bool closed =
      fault_ == EndStopFault::never_opens || (fault_ == EndStopFault::none && position <= 0);
  const auto mask = static_cast<std::uint8_t>(1U << input_);
  inputs_.end_stops =
      static_cast<std::uint8_t>(closed ? inputs_.end_stops | mask : inputs_.end_stops & ~mask);
}

}  // namespace devices
