// SPDX-License-Identifier: Apache-2.0
// A rising edge on a step pin and what it did, for all listeners.
#pragma once

#include <cstddef>
#include <cstdint>

#include "sim/simulation/pins.hpp"

namespace devices {

struct StepEdge {
  sim::Clock clock{};
  std::size_t axis{};
  int direction{};  // 1 or -1
  std::int64_t position{};  // of the axis after this edge, in steps; 0 where its end stop switches
};

class StepListener {
 public:
  StepListener() = default;
  StepListener(const StepListener&) = delete;
  StepListener& operator=(const StepListener&) = delete;
  virtual ~StepListener() = default;
  virtual void stepped(const StepEdge& edge) = 0;
};

}  // namespace devices
