// SPDX-License-Identifier: Apache-2.0
// Hotends and beds at random within the tolerances of the parts, in prints at random, with a fault
// or without, under the firmware's loop.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <random>

#include "tests/thermal/closed_loop.hpp"

namespace tests {

enum class HeatFault : std::uint8_t { none, frozen, drifting, detached, stuck_on };

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  // The same with every standard library.
  double operator()(double from, double to) {
    return from + (to - from) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  bool chance(double share) { return (*this)(0, 1) < share; }
  double normal() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += (*this)(0, 1);
    return sum;
  }

 private:
  std::mt19937_64 engine_;
};

// What differs between a hotend and a bed.
struct PlantKind {
  plants::HeatedBlockProperties nominal;
  thermal::HeaterSettings settings;
  double least_target, most_target;
  double change_every;  // s: target, fan, filament, draught
  double draught;  // of the loss in still air, at most
  bool melts;
};

inline PlantKind hotend_kind() {
  return {tests::described_hotend(), hotend_settings(), 170, 255, 40, 0.3, true};
}
inline PlantKind bed_kind() {
  return {tests::described_bed(), bed_settings(), 45, 100, 200, 0.3, false};
}

inline plants::HeatedBlockProperties random_plant(const PlantKind& kind, Random& random) {
  plants::HeatedBlockProperties plant = kind.nominal;
  // Resistance of the cartridge, and 12 V less 10 %.
  const double volts = random(0.9, 1.0);
  plant.heater_watts *= random(0.85, 1.15) * volts * volts;
  plant.loss_watts_per_kelvin *= random(0.6, 1.4);
  plant.fan_loss_watts_per_kelvin *= random(0.6, 1.4);
  plant.path.heater_joules_per_kelvin *= random(0.7, 1.3);
  plant.path.heater_to_block_watts_per_kelvin *= random(0.7, 1.3);
  plant.path.block_joules_per_kelvin *= random(0.9, 1.1);
  plant.path.sensor_lag_seconds *= random(0.7, 1.3);
  return plant;
}

struct RandomPrint {
  std::optional<thermal::Fault> fault;
  double broken_at = -1;
  double matters_at = -1;  // the block is 5 K above target for the first time after the fault
  double ended_at = 0;
  double highest_above = -300;  // block above the target, after the fault
  double highest = -300;  // block
  double heated = 0;  // s at full power before it broke
  bool held = false;  // when it broke
  bool climbed = false;  // with all its heat, more than 3 K below the target, when it broke
};

class RandomPrinter {
 public:
  RandomPrinter(const PlantKind& kind, std::uint64_t seed)
      : kind_(kind),
        random_(seed),
        properties_(random_plant(kind, random_)),
        ambient_(random_(15, 35)),
        start_(random_.chance(0.5) ? ambient_ : random_(ambient_, kind.most_target)),
        block_(properties_, ambient_, start_),
        loop_(kind.settings),
        noise_(random_(0.01, 0.12)) {}

  // `fault` comes at a random time of the first `seconds`, which pass again after it.
  RandomPrint run(HeatFault fault, double seconds) {
    RandomPrint print;
    const double fault_at = random_(0, seconds);
    double next_change = 1;
    for (;;) {
      const double now = now_;
      if (now >= next_change) {
        change();
        next_change = now + random_(0.1, 2) * kind_.change_every;
      }
      if (fault != HeatFault::none && print.broken_at < 0 && now >= fault_at) {
        break_it(fault);
        print.broken_at = now;
        print.heated = heated_;
        print.held = loop_.at_target() && target_ > 0;
        print.climbed = loop_.duty() == thermal::full_duty &&
                        block_.sensor_celsius(now) < target_ - 3 && heating_ > 3;
      }
      const double reading = block_.sensor_celsius(now) + noise_ * random_.normal();
      loop_.set_cooling({.fan = static_cast<std::uint8_t>(std::lround(fan_ * 255)),
                         .filament = units::MicrometersPerSecond(
                             static_cast<std::int32_t>(flow_ / 2.405 * 1000))});
      const thermal::Duty duty =
          loop_.update(celsius(reading), units::Milliseconds(std::llround(now * 1000)));
      const double block = block_.celsius(now);
      if (print.broken_at >= 0) print.highest = std::max(print.highest, block);
      if (print.broken_at >= 0) {
        print.highest_above = std::max(print.highest_above, block - wanted_);
        if (print.matters_at < 0 && block > wanted_ + 5 && block > at_break_ + 3) {
          print.matters_at = now;
        }
      }
      print.ended_at = now;
      if ((print.fault = loop_.fault())) return print;
      if (now > (fault == HeatFault::none ? seconds : fault_at + seconds)) return print;
      heated_ += duty / 65535.0 * period;
      heating_ = duty == thermal::full_duty ? heating_ + period : 0;
      heat(duty);
    }
  }

 private:
  void heat(thermal::Duty duty) {
    constexpr int slots = 4;
    for (int i = 0; i < slots; ++i) {
      density_ += static_cast<std::uint32_t>(duty * supply_);
      const bool on = density_ >= thermal::full_duty;
      if (on) density_ -= thermal::full_duty;
      block_.set_heater(now_, on);
      now_ += period / slots;
    }
  }
  // The highest target that this heater holds in the worst wind with a quarter of its power left:
  // with less it may pass for one that fails.
  double reachable() const {
    const double loss = properties_.loss_watts_per_kelvin * (1 + kind_.draught) +
                        properties_.fan_loss_watts_per_kelvin + (kind_.melts ? 0.024 : 0.0);
    return ambient_ + 0.75 * properties_.heater_watts / loss;
  }
  void change() {
    const double now = now_;
    const double what = random_(0, 1);
    if (target_ == 0 || what < 0.1) {
      target_ = random_(kind_.least_target, std::min(reachable(), kind_.most_target));
    } else if (what < 0.15) {
      target_ = 0;
    } else if (what < 0.3) {
      target_ = std::clamp(target_ + random_(-20, 20), kind_.least_target,
                           std::max(kind_.least_target, std::min(reachable(), kind_.most_target)));
    } else if (what < 0.55) {
      fan_ = random_.chance(0.3) ? 0 : random_.chance(0.5) ? 1 : random_(0, 1);
    } else if (what < 0.6) {
      supply_ = random_(0.9, 1.0);  // the other heater goes on or off
    } else if (what < 0.8 && kind_.melts) {
      flow_ = random_.chance(0.3) ? 0 : random_(0, 10);
    } else {
      draught_ = random_.chance(0.5) ? 0 : random_(0, kind_.draught);
    }
    wanted_ = std::max(target_, std::min(wanted_, block_.celsius(now)));
    loop_.set_target(celsius(target_));
    const double wind =
        draught_ * properties_.loss_watts_per_kelvin / properties_.fan_loss_watts_per_kelvin;
    block_.set_fan(now, fan_ + wind);
    block_.set_extrusion(now, flow_);
  }
  void break_it(HeatFault fault) {
    at_break_ = block_.celsius(now_);
    wanted_ = std::max(target_, at_break_);
    if (fault == HeatFault::stuck_on) return block_.set_fault(now_, plants::HeaterFault::stuck_on);
    block_.set_bead_fault(now_, fault == HeatFault::frozen     ? plants::BeadFault::frozen
                                : fault == HeatFault::drifting ? plants::BeadFault::drifting
                                                               : plants::BeadFault::detached);
  }

  PlantKind kind_;
  Random random_;
  plants::HeatedBlockProperties properties_;
  double ambient_, start_;
  plants::HeatedBlock block_;
  thermal::HeaterLoop loop_;
  double noise_;
  double now_ = 0, heated_ = 0;
  double heating_ = 0;  // s at full power without a pause
  std::uint32_t density_ = 0;
  double target_ = 0, wanted_ = 0, at_break_ = 0, fan_ = 0, flow_ = 0, draught_ = 0, supply_ = 1;
};

}  // namespace tests
