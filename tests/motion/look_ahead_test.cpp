// SPDX-License-Identifier: Apache-2.0
// Each line begins as fast as all lines that the ring has then permit, whenever the planner looks
// ahead: held against both passes over the whole ring, in double precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <random>

#include "motion/junction.hpp"
#include "motion/planner.hpp"
#include "tests/motion/machine.hpp"

namespace {

using motion_test::at;

constexpr std::int64_t step_nm = 12'500;
// Longer than any interval that counts as one between lines (Supply).
constexpr units::Microseconds pause{200'000};

struct PlannedLine {
  double work, max_entry, entry, least, rate_of_root;
};

class LookAhead {
 public:
  explicit LookAhead(std::uint64_t seed) : random_(seed) {}

  std::int64_t within(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random_);
  }

  void append() {
    const bool short_line = within(0, 3) != 0;
    const std::int64_t most = short_line ? 40 : 2000;
    const std::int64_t dx = within(1, most), dy = within(0, 9) == 0 ? -within(0, most) : 0;
    const std::int64_t direction = within(0, 19) == 0 ? -1 : 1;
    x_ += direction * dx;
    y_ += dy;
    const units::MicrometersPerSecond feedrate(static_cast<std::int32_t>(within(20'000, 200'000)));
    motion::Displacement displacement;
    displacement.distance = {units::Nanometers(direction * dx * step_nm),
                             units::Nanometers(dy * step_nm)};
    displacement.steps = {static_cast<std::int32_t>(direction * dx), static_cast<std::int32_t>(dy)};
    motion::Line line;
    const motion::Course course = geometry_.make_line(displacement, feedrate, {}, line);
    const motion::SpecificEnergy entry =
        ring_.empty() ? motion::energy_from_rest(course, limits_)
                      : motion::junction_energy(last_course_, course, limits_);
    last_course_ = course;
    const auto count = [](motion::SpecificEnergy energy) {
      return static_cast<double>(energy.count());
    };
    const double work = count(line.work);
    ring_.push_back({.work = work,
                     .max_entry = count(entry),
                     .entry = count(entry),
                     .least = std::min(work / line.ticks() / 2, count(line.nominal())),
                     .rate_of_root = std::ldexp(line.rate_of_root().mantissa(),
                                                line.rate_of_root().exponent())});
    ASSERT_TRUE(
        planner_
            .append({.target = at(x_ * step_nm, y_ * step_nm, 0, 0), .feedrate = feedrate}, now_)
            .has_value());
  }

  // False where nothing is to be handed over now.
  bool hand_over() {
    const std::size_t lines = planner_.lines();
    const auto segment = planner_.next_segment(now_);
    if (!segment) return false;
    if (planner_.lines() == lines) return true;
    // Its first segment, at the energy that was planned when the line before it went, or now.
    if (resting_) look_ahead();
    const PlannedLine line = ring_.front();
    const double half_acceleration = std::ldexp(static_cast<double>(segment->acceleration), -85);
    const double rate = std::ldexp(static_cast<double>(segment->rate), -64) - half_acceleration;
    const double planned = std::sqrt(std::max(line.entry, line.least)) * line.rate_of_root;
    worst_ = std::max(worst_, std::abs(rate / planned - 1));
    resting_ = false;
    look_ahead();
    ring_.pop_front();
    resting_ = ring_.empty();
    return true;
  }

  void run() {
    for (int burst = 0; burst < 20; ++burst) {
      const auto room = static_cast<std::int64_t>(motion::Planner::capacity - planner_.lines());
      for (std::int64_t i = within(0, within(0, 1) == 0 ? 3 : room); i > 0 && room > 0; --i) {
        if (planner_.has_room()) append();
      }
      now_ += pause;
      for (std::int64_t i = within(0, 120); i > 0 && hand_over(); --i) {
      }
    }
    planner_.flush();
    while (!planner_.empty()) {
      if (!hand_over()) now_ += pause;
    }
  }

  double worst() const { return worst_; }

 private:
  void look_ahead() {
    double exit = 0;
    for (std::size_t i = ring_.size() - 1; i > 0; --i) {
      exit = ring_[i].entry = std::min(ring_[i].max_entry, exit + ring_[i].work);
    }
    if (resting_) ring_[0].entry = std::min(ring_[0].max_entry, exit + ring_[0].work);
    for (std::size_t i = 1; i < ring_.size(); ++i) {
      ring_[i].entry = std::min(ring_[i].entry, ring_[i - 1].entry + ring_[i - 1].work);
    }
  }

  std::mt19937_64 random_;
  motion::Limits limits_ = motion_test::mendel();
  motion::StepTiming timing_ = motion_test::timing(50'000'000);
  motion::Geometry geometry_{limits_, timing_};
  motion::Planner planner_{limits_, timing_};
  motion::Course last_course_{};
  std::deque<PlannedLine> ring_;
  std::int64_t x_ = 0, y_ = 0;
  units::Microseconds now_{1'000'000};
  bool resting_ = true;  // what has been handed over
  double worst_ = 0;
};

TEST(look_ahead, each_line_begins_as_fast_as_the_whole_ring_permits) {
  double worst = 0;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    LookAhead run(seed);
    run.run();
    ASSERT_LT(run.worst(), 1e-5) << seed;
    worst = std::max(worst, run.worst());
  }
  RecordProperty("worst", std::to_string(worst));
}

}  // namespace
