// SPDX-License-Identifier: Apache-2.0
// An end stop switch: closed while its axis stands at 0 or below.
#pragma once

#include "sim/devices/step_edge.hpp"
#include "sim/simulation/pins.hpp"

namespace devices {

enum class EndStopFault : std::uint8_t { none, never_closes, never_opens };

class EndStop : public StepListener {
 public:
  EndStop(std::size_t axis, std::size_t input, sim::InputPins& inputs, std::int64_t position,
          EndStopFault fault = EndStopFault::none);

  void stepped(const StepEdge& edge) override;
  bool closed() const { return (inputs_.end_stops >> input_ & 1) != 0; }

 private:
  void set_position(std::int64_t position);

  std::size_t axis_;
  std::size_t input_;
  sim::InputPins& inputs_;
  EndStopFault fault_;
};

}  // namespace devices
