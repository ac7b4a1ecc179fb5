// SPDX-License-Identifier: Apache-2.0
// The probe's contact, looked at after each step.
#include "sim/devices/probe.hpp"

#include <utility>

namespace devices {

Probe::Probe(std::size_t input, sim::InputPins& inputs,
             const std::array<std::int64_t, 4>& positions, Triggers triggers, EndStopFault fault)
    : input_(input),
      inputs_(inputs),
      positions_(positions),
      triggers_(std::move(triggers)),
      fault_(fault) {
  show();
}

void Probe::stepped(const StepEdge& edge) {
  if (edge.axis >= positions_.size()) return;
  positions_[edge.axis] = edge.position;
  show();
}

void Probe::show() {
  const bool closed = fault_ == EndStopFault::never_opens ||
                      (fault_ != EndStopFault::never_closes && triggers_(positions_));
  const auto mask = static_cast<std::uint8_t>(1U << input_);
  inputs_.end_stops =
      static_cast<std::uint8_t>(closed ? inputs_.end_stops | mask : inputs_.end_stops & ~mask);
}

}  // namespace devices
