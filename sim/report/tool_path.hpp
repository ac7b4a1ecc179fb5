// SPDX-License-Identifier: Apache-2.0
// The path of the nozzle as the pulses drew it, thinned to what an eye can see.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/devices/step_edge.hpp"

namespace report {

struct ToolPoint {
  float x{}, y{}, z{};  // mm
  bool extruding{};  // filament was pushed on the way from the point before to this one
};

class ToolPath : public devices::StepListener {
 public:
  // Positions in steps at the beginning, for x y z e.
  ToolPath(std::array<double, 4> steps_per_mm, std::array<std::int64_t, 4> positions);

  void stepped(const devices::StepEdge& edge) override;
  // Forgets the path so far, which was not yet in the coordinates of the machine.
  void begin_here();
  // The points so far, and where the nozzle stands.
  std::vector<ToolPoint> points() const;

 private:
  ToolPoint present() const;
  void keep();

  std::array<double, 4> steps_per_mm_;
  std::array<std::int64_t, 4> positions_;
  std::array<std::int64_t, 4> kept_;
  std::vector<ToolPoint> points_;
};

// Leaves out the points that lie within `tolerance_mm` of a straight line between those that stay
// (Douglas, Peucker 1973).
std::vector<ToolPoint> simplified(const std::vector<ToolPoint>& points, double tolerance_mm);

}  // namespace report
