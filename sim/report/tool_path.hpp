// SPDX-License-Identifier: Apache-2.0
// The path of the nozzle as the pulses drew it, thinned to what an eye can see.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "sim/devices/step_edge.hpp"
#include "sim/machine/mechanism.hpp"
#include "sim/simulation/clock_rate.hpp"

namespace report {

struct ToolPoint {
  float x{}, y{}, z{};  // mm from the end stop; from the beginning while the axis is not homed
  bool extruding{};  // filament was pushed on the way from the point before to this one
  double seconds{};
};

// Every edge is a point at first (those of one clock are one). What is left out lies within
// tolerance_steps of the lines between the points that stay: a straight line of the G-code is a
// staircase of steps around it. A nozzle that stands gives two points at one place.
class ToolPath : public devices::StepListener {
 public:
  static constexpr double tolerance_steps = 0.75;

  // Positions in steps at the beginning, for x y z e.
  ToolPath(sim::ClockRate rate, std::array<double, 4> steps_per_mm,
           std::array<std::int64_t, 4> positions,
           std::shared_ptr<const machine::Mechanism> mechanism = machine::cartesian_mechanism());

  void stepped(const devices::StepEdge& edge) override;
  // These axes stand in the coordinates of the machine from now on. Where one of them did not
  // before, the path so far is forgotten, and the answer is true.
  bool homed(std::array<bool, 3> axes);
  // The points so far, and where the nozzle stands.
  std::vector<ToolPoint> points() const;

 private:
  std::array<double, 3> place_mm() const;
  ToolPoint present() const;
  void begin_here();
  void keep_present();
  void extruder_stepped(int direction);
  void thin();

  sim::ClockRate rate_;
  std::array<double, 4> steps_per_mm_;
  std::array<std::int64_t, 4> positions_;
  std::shared_ptr<const machine::Mechanism> mechanism_;
  std::array<double, 3> origin_mm_;
  std::array<bool, 3> homed_{};
  double tolerance_mm_;
  sim::Clock clock_ = 0;  // of the latest edge of x, y or z
  bool moved_ = false;  // since the latest kept point
  std::vector<ToolPoint> points_;  // thinned
  std::vector<ToolPoint> latest_;  // all of them, from the last of points_ on
  std::size_t extruded_at_ = 0;  // index in latest_ at the latest step of the extruder
  double way_since_extruded_mm_;
};

// Leaves out the points that lie within `tolerance_mm` of a straight line between those that stay
// (Douglas, Peucker 1973). Ends of travel and of rests stay.
std::vector<ToolPoint> simplified(const std::vector<ToolPoint>& points, double tolerance_mm);

}  // namespace report
