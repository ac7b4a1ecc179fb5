// SPDX-License-Identifier: Apache-2.0
// A planner of trapezoids, in double precision: where the axes are at any time without a shaper.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace tests {

using Axes = std::array<double, 4>;  // x y z e

// Straight, at one speed at most.
struct Way {
  Axes from{}, to{};  // steps
  double length_mm{};
  double speed_mm_s{};
  bool prints{};
  double pause_s{};  // after it, at rest; negative: none, it goes on at the corner's speed
  std::size_t command{};  // that it belongs to
};

struct PlanLimits {
  Axes steps_per_mm{80, 80, 2560, 500};
  Axes jerk_mm_s{10, 10, 1, 5};
  Axes most_mm_s{300, 300, 12, 45};
  double acceleration_mm_s2 = 1500;
};

// All ways from rest to rest.
class Plan {
 public:
  Plan(std::vector<Way> ways, const PlanLimits& limits);

  double seconds() const {
    return phases_.empty() ? 0 : phases_.back().start + phases_.back().time;
  }
  // When a way begins, or the one before it has come to its end.
  double start_of(std::size_t way) const { return way < starts_.size() ? starts_[way] : seconds(); }
  const std::vector<Way>& ways() const { return ways_; }

  // Looks up positions at times that rise from call to call.
  class Cursor {
   public:
    explicit Cursor(const Plan& plan) : plan_(&plan) {}
    // Of one axis; 4: what E has printed.
    double at(double time, std::size_t axis);

   private:
    const Plan* plan_;
    std::size_t phase_ = 0;
  };

 private:
  struct Phase {
    double start{}, time{};
    std::size_t way{};
    double part{}, speed{}, acceleration{};  // of the way, per second
  };
  void add_phase(std::size_t way, double& done_mm, double from_mm_s, double acceleration,
                 double time);
  double corner_speed(const Way& before, const Way& after, const PlanLimits& limits) const;

  std::vector<Way> ways_;
  std::vector<double> printed_;  // by E before each way
  std::vector<double> starts_;
  std::vector<Phase> phases_;
};

}  // namespace tests
