// SPDX-License-Identifier: Apache-2.0
// One heater with its loop in any circumstances: room, fan, filament, supply, and a sensor that
// reads what a test wants.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>

#include "tests/thermal/closed_loop.hpp"

namespace tests {

enum class Part : std::uint8_t { hotend, bed };

struct RigSettings {
  double power = 1, loss = 1;  // of what is described
  double room = 22;
  double start = 22;
  double noise = 0.03;  // of a conversion, standard deviation in kelvin
  std::uint64_t seed = 1;
};

class Rig {
 public:
  // Called before each update with the rig and its time.
  using Script = std::function<void(Rig&, double)>;

  explicit Rig(Part part, const RigSettings& settings = {})
      : noise(settings.noise),
        block(properties(part, settings), settings.room, settings.start),
        loop(part == Part::bed ? bed_settings() : hotend_settings()),
        random_(settings.seed) {}

  void set_target(double degrees) {
    if (degrees == target_) return;
    target_ = degrees;
    loop.set_target(celsius(degrees));
  }
  // Until a fault, `seconds` later, or when `done`.
  void run(
      double seconds, const Script& script = [](Rig&, double) {},
      const std::function<bool()>& done = [] { return false; }) {
    const double end = now + seconds;
    while (now < end && !loop.fault() && !done()) {
      script(*this, now);
      block.set_fan(now, fan + draught);
      block.set_extrusion(now, flow);
      constexpr double filament_square_mm = 2.405;
      loop.set_cooling({.fan = static_cast<std::uint8_t>(std::lround(std::min(fan, 1.0) * 255)),
                        .filament = units::MicrometersPerSecond(
                            static_cast<std::int32_t>(flow / filament_square_mm * 1000))});
      const double reading = sense(block.sensor_celsius(now), now) + noise * normal();
      const thermal::Duty duty =
          loop.update(celsius(reading), units::Milliseconds(std::llround(now * 1000)));
      note(block.celsius(now));
      if (!loop.fault()) heat(stuck_at ? *stuck_at * thermal::full_duty : duty * supply);
    }
  }
  // Warm and settled.
  void hold(double degrees, double seconds) {
    set_target(degrees);
    run(3'000, [](Rig&, double) {}, [this] { return loop.at_target(); });
    run(seconds);
    highest = -300;
  }
  void freeze() {
    const double reading = block.sensor_celsius(now);
    sense = [reading](double, double) { return reading; };
  }
  // By so much less from now on.
  void drift(double kelvin_per_second) {
    const double begin = now;
    sense = [=](double degrees, double time) {
      return degrees - kelvin_per_second * (time - begin);
    };
  }

  double fan = 0, flow = 0;  // of full speed, mm^3/s
  double draught = 0;  // as a fan that the loop does not know of
  double supply = 1;  // of full power
  double noise;
  std::optional<double> stuck_at;  // what the heater gets instead of its duty, of full power
  std::function<double(double, double)> sense = [](double degrees, double) { return degrees; };
  double now = 0;
  double highest = -300;  // of the block
  double farthest = 0;  // from the target, once arrived
  plants::HeatedBlock block;
  thermal::HeaterLoop loop;

 private:
  static plants::HeatedBlockProperties properties(Part part, const RigSettings& settings) {
    plants::HeatedBlockProperties block = part == Part::bed ? described_bed() : described_hotend();
    block.heater_watts *= settings.power;
    block.loss_watts_per_kelvin *= settings.loss;
    return block;
  }
  // Nearly normal, and the same with every library.
  double normal() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += static_cast<double>(random_() >> 11) * 0x1p-53;
    return sum;
  }
  void note(double degrees) {
    highest = std::max(highest, degrees);
    if (target_ > 0 && loop.at_target()) farthest = std::max(farthest, std::abs(degrees - target_));
  }
  void heat(double duty) {
    constexpr int slots = 4;
    for (int i = 0; i < slots; ++i) {
      density_ += duty;
      const bool on = density_ >= thermal::full_duty;
      if (on) density_ -= thermal::full_duty;
      block.set_heater(now, on);
      now += period / slots;
    }
  }

  std::mt19937_64 random_;
  double density_ = 0;
  double target_ = 0;
};

}  // namespace tests
