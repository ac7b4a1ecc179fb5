// SPDX-License-Identifier: Apache-2.0
// Keeps simulated time in step with real time, and reports how well it does.
#pragma once

#include <chrono>
#include <thread>

namespace command {

class Pacer {
 public:
  explicit Pacer(bool real_time) : real_time_(real_time), origin_(Time::now()), started_(origin_) {}

  // Sleeps as long as the simulation is ahead. A model that has fallen behind may catch up only a
  // little: hosts would see a printer that is faster than any.
  void keep(double simulated_seconds) {
    if (!real_time_) return;
    const Time::time_point due = origin_ + duration(simulated_seconds);
    const Time::time_point now = Time::now();
    if (due > now) {
      std::this_thread::sleep_until(due);
    } else if (now - due > longest_lag) {
      origin_ += now - due - longest_lag;
    }
  }

  double wall_seconds() const {
    return std::chrono::duration<double>(Time::now() - started_).count();
  }

 private:
  using Time = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds longest_lag{100};

  static Time::duration duration(double seconds) {
    return std::chrono::duration_cast<Time::duration>(std::chrono::duration<double>(seconds));
  }

  bool real_time_;
  Time::time_point origin_;
  Time::time_point started_;
};

}  // namespace command
