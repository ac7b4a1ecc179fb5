// SPDX-License-Identifier: Apache-2.0
// What the simulation of this thread does at the moment, for a profile by samples of its time.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace sim {

// `loop`: what is between the others, above all that outputs are sampled and compared.
enum class Activity : std::uint8_t {
  loop,
  processor_model,
  leaps,
  netlist,
  devices,
  host_and_report
};

inline constexpr std::size_t activity_count = 6;

// Read by a signal's handler in the same thread.
inline constinit thread_local std::atomic<Activity> current_activity = Activity::loop;

// Until its end, and then what was before.
class ActivityScope {
 public:
  explicit ActivityScope(Activity activity) { set(activity); }
  ActivityScope(const ActivityScope&) = delete;
  ActivityScope& operator=(const ActivityScope&) = delete;
  ~ActivityScope() { set(before_); }

 private:
  static void set(Activity activity) {
    current_activity.store(activity, std::memory_order_relaxed);
  }

  Activity before_ = current_activity.load(std::memory_order_relaxed);
};

}  // namespace sim
