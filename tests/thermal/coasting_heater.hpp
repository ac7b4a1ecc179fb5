// SPDX-License-Identifier: Apache-2.0
// A heater under the pauses of its heat-up alone: exact windows, and no control.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

#include "machine/machine.hpp"
#include "thermal/coast.hpp"

namespace tests {

inline constexpr double room = 22;

// A heater with the lags of its description, all the heat on but in pauses.
struct CoastingHeater {
  explicit CoastingHeater(const thermal::HeaterModel& described = machine::machine.hotend.model)
      : model(described), coast(described) {}

  // Until it is found or `done`, at most so many seconds; true if it is found.
  bool run(
      double seconds, const std::function<void()>& script = [] {},
      const std::function<bool()>& done = [] { return false; }) {
    for (const double end = now + seconds; now < end && !done();) {
      script();
      if (update()) return true;
    }
    return false;
  }
  bool heat_up_to(double degrees) {
    return run(1'000, [] {}, [this, degrees] { return reading >= degrees; });
  }

  const thermal::HeaterModel& model;
  thermal::Coast coast;
  // Of what is described.
  double power = 1, loss = 1, supply = 1, draught = 0;
  double drift = 0;  // K/s
  double late = 0;  // K/s of heat that the model does not know of, and by how much it becomes less
  double late_seconds = 2;
  double noise = 0.1;  // that windows tell of, from end to end, in K
  bool frozen = false, held = false, wanted = true;
  double target = 250;
  double block = room, reading = room;
  double now = 0;
  // Pauses that have begun, those of them within 8 s of wanted heat after another, the longest one
  // in s.
  int pauses = 0, sudden = 0;
  double longest = 0;

 private:
  bool update() {
    if (!wanted) coast.restart();
    const bool full = wanted && reading < target;
    const bool pausing = wanted && coast.pause({.celsius = millis(reading),
                                                .below = millis(target - reading),
                                                .full = full,
                                                .held = held,
                                                .milliseconds = 100});
    count(pausing);
    advance(full && !pausing ? 1 : 0);
    sum_ += felt_;
    if (++updates_ % 10 != 0) return false;
    const double slope = reading - before_;
    const double heating = sum_ / 10;
    before_ = reading;
    sum_ = 0;
    return wanted &&
           coast.add({.slopes = {.measured = millis(slope),
                                 .heating = static_cast<std::int32_t>(heating * model.rise),
                                 .still = millis(lost_at(reading - slope / 2, 25))},
                      .celsius = millis(reading),
                      .noise = millis(noise),
                      .milliseconds = 1'000});
  }
  void count(bool pausing) {
    if (pausing && !was_pausing_) {
      ++pauses;
      sudden += heated_ < 7.85;
      paused_ = 0;
    }
    was_pausing_ = pausing;
    paused_ += pausing ? 0.1 : 0;
    longest = std::max(longest, paused_);
    heated_ = wanted && !pausing ? heated_ + 0.1 : 0;
  }
  void advance(double duty) {
    now += 0.1;
    const auto follow = [](double& state, double input, units::Milliseconds lag) {
      state += (input - state) * 100 / (100 + static_cast<double>(lag.count()));
    };
    follow(arriving_, duty, model.heater_lag);
    follow(felt_, arriving_, model.sensor_lag);
    const double slope = felt_ * power * supply * model.rise / 1e3 + late -
                         lost_at(block, room) * loss * (1 + draught);
    late -= late * 0.1 / late_seconds;
    block += slope / 10;
    if (!frozen) reading += (slope - drift) / 10;
  }
  double lost_at(double degrees, double surroundings) const {
    return std::max(degrees - surroundings, 0.0) * model.loss / 1e6;
  }
  static std::int32_t millis(double value) {
    return static_cast<std::int32_t>(std::lround(value * 1e3));
  }

  double arriving_ = 0, felt_ = 0, sum_ = 0, before_ = room;
  int updates_ = 0;
  bool was_pausing_ = false;
  double paused_ = 0, heated_ = 0;
};

}  // namespace tests
