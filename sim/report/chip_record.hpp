// SPDX-License-Identifier: Apache-2.0
// The step generator's queue and the load of the processor over time.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/report/range_course.hpp"
#include "sim/simulation/chip.hpp"
#include "sim/simulation/clock_rate.hpp"
#include "sim/simulation/device.hpp"

namespace report {

struct Underruns {
  double seconds{};
  std::uint64_t count{};
};

struct ChipCourse {
  RangeCourse queue_depth;
  RangeCourse processor_busy_percent;
  std::vector<Underruns> underruns;
};

// Looks at the chip's own statistics: at the depth once in each look_seconds, so that a depth that
// lasts shorter may be missed; underruns are counted by the chip and are not.
class ChipRecord : public sim::Device {
 public:
  static constexpr double look_seconds = 0.001;
  static constexpr std::uint64_t looks_per_load = 20;
  static constexpr std::size_t most_underruns = 2000;

  ChipRecord(const sim::Chip& chip, sim::ClockRate rate);

  void wake(sim::Clock now) override;
  const ChipCourse& course() const { return course_; }

 private:
  void put_load(sim::Clock now);

  const sim::Chip& chip_;
  sim::ClockRate rate_;
  sim::Clock look_clocks_;
  std::uint64_t looks_ = 0;
  std::uint64_t underruns_ = 0;
  sim::Clock load_since_ = 0;
  std::uint64_t sleeping_clocks_ = 0;
  ChipCourse course_;
};

}  // namespace report
