// SPDX-License-Identifier: Apache-2.0
// A probe next to the nozzle: its contact is closed while the bed is as near as it needs.
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "sim/devices/end_stop.hpp"
#include "sim/devices/step_edge.hpp"

namespace devices {

class Probe : public StepListener {
 public:
  // Whether the bed is so near where the motors (x y z e) stand, in steps.
  using Triggers = std::function<bool(const std::array<std::int64_t, 4>& positions)>;

  // On an input of the end stops; of their faults it may have those that last.
  Probe(std::size_t input, sim::InputPins& inputs, const std::array<std::int64_t, 4>& positions,
        Triggers triggers, EndStopFault fault);

  void stepped(const StepEdge& edge) override;

 private:
  void show();

  std::size_t input_;
  sim::InputPins& inputs_;
  std::array<std::int64_t, 4> positions_;
  Triggers triggers_;
  EndStopFault fault_;
};

}  // namespace devices
