// SPDX-License-Identifier: Apache-2.0
// What the simulation of a thread does, sampled in equal steps of that thread's processor time.
#pragma once

#include <array>
#include <cstdint>
#include <ctime>

#include "sim/simulation/activity.hpp"

namespace benchmarks {

using ActivityCounts = std::array<std::uint64_t, sim::activity_count>;

// Of the thread that makes it, by the signal SIGPROF; one at a time in a process.
class ActivitySamples {
 public:
  // Throws std::system_error where the system has no such timer.
  ActivitySamples();
  ActivitySamples(const ActivitySamples&) = delete;
  ActivitySamples& operator=(const ActivitySamples&) = delete;
  ~ActivitySamples();

  // So far, by activity.
  ActivityCounts counts() const;

 private:
  timer_t timer_{};
};

}  // namespace benchmarks
