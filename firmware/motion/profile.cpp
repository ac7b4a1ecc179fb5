// SPDX-License-Identifier: Apache-2.0
// Cuts a line into its phases.
#include "motion/profile.hpp"

#include <algorithm>
#include <optional>

#include "motion/s_curve.hpp"

namespace motion {

namespace {

// Half a tick per clock in the segment's format, 2^-64: the hardware's bound.
constexpr std::uint64_t highest_rate = std::uint64_t{1} << 63;
constexpr int rate_fraction_bits = 64;
constexpr int acceleration_fraction_bits = 84;
constexpr std::uint64_t largest_acceleration = ~std::uint64_t{0} >> 1;
// Rates add half an acceleration, which has this many more fraction bits.
constexpr int half_acceleration_shift = acceleration_fraction_bits - rate_fraction_bits + 1;

Scaled scaled(SpecificEnergy energy) { return Scaled::of(energy.count()); }

// How many ticks, of the energy `per_tick` each, lie between two energies; rounded down.
std::uint32_t ticks_between(SpecificEnergy low, SpecificEnergy high, Scaled per_tick) {
  const std::uint64_t ticks = (scaled(high - low) / per_tick).floor();
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(ticks, 0x7FFF'FFFF));
}

// The fewest ticks in which `per_tick` bridges the difference.
std::uint32_t ticks_needed(SpecificEnergy low, SpecificEnergy high, Scaled per_tick) {
  return high <= low ? 0 : ticks_between(low, high, per_tick) + 1;
}

SpecificEnergy energy_of_ticks(std::uint32_t ticks, Scaled per_tick) {
  return SpecificEnergy((Scaled::of_word(ticks) * per_tick).floor());
}

// The energies of the phases, and their ticks.
struct EnergyCourse {
  SpecificEnergy entry, peak, exit;
  std::uint32_t ticks;  // of the line
  std::uint32_t accelerating, braking;
};

// The highest energy between these ends.
SpecificEnergy peak_of(const Line& line, SpecificEnergy nominal, SpecificEnergy entry,
                       SpecificEnergy exit, std::uint32_t min_cruise_percent) {
  if (min_cruise_percent == 0) return nominal;
  // The work is at most 2^60.
  const SpecificEnergy ramps = line.work / 128 * (128 - min_cruise_percent * 128 / 100);
  const SpecificEnergy peak = entry / 2 + exit / 2 + ramps / 2;
  return std::min(nominal, std::max({entry, exit, peak}));
}

EnergyCourse course_of(const Line& line, SpecificEnergy exit, std::uint32_t min_cruise_percent) {
  const std::uint32_t ticks = line.ticks();
  const Scaled per_tick = scaled(line.work) / Scaled::of_word(ticks);
  const SpecificEnergy nominal = line.nominal();
  const SpecificEnergy least = std::min(SpecificEnergy(per_tick.half().floor()), nominal);
  EnergyCourse course{.entry = std::clamp(line.entry, least, nominal),
                      .peak = {},
                      .exit = std::clamp(exit, least, nominal),
                      .ticks = ticks,
                      .accelerating = 0,
                      .braking = 0};
  course.peak = peak_of(line, nominal, course.entry, course.exit, min_cruise_percent);
  course.accelerating = ticks_needed(course.entry, course.peak, per_tick);
  course.braking = ticks_needed(course.exit, course.peak, per_tick);
  if (std::uint64_t{course.accelerating} + course.braking <= ticks) return course;

  // The nominal speed is not reached: the peak lies where both ramps meet, at the nearest tick.
  const SpecificEnergy top = line.work + course.exit;
  const SpecificEnergy gained = top > course.entry ? top - course.entry : SpecificEnergy();
  const std::uint32_t half_ticks = ticks_between(SpecificEnergy(), gained, per_tick);
  course.accelerating = std::min((half_ticks + 1) / 2, ticks);
  course.braking = ticks - course.accelerating;
  if (course.accelerating == 0) {
    course.peak = course.entry;
  } else if (course.braking == 0) {
    course.peak = course.exit;
  } else {
    course.peak = std::min({course.entry + energy_of_ticks(course.accelerating, per_tick),
                            course.exit + energy_of_ticks(course.braking, per_tick), nominal});
  }
  return course;
}

std::uint64_t rate_of(const Line& line, SpecificEnergy energy) {
  const Scaled rate = scaled(energy).square_root() * line.rate_of_root();
  return std::clamp<std::uint64_t>(rate.floor(rate_fraction_bits), 1, highest_rate);
}

// Collects the phases of a profile.
class Builder {
 public:
  Builder(const Line& line, bool s_curve, Profile& profile)
      : rate_of_root_(line.rate_of_root()), profile_(profile), s_curve_(s_curve) {
    profile_.count = 0;
  }

  // From an energy to another, and between their rates.
  void add_ramp(std::uint32_t ticks, SpecificEnergy from, SpecificEnergy to,
                std::uint64_t from_rate, std::uint64_t to_rate) {
    if (s_curve_in_image && s_curve_ && add_s_curve(ticks, from_rate, to_rate)) return;
    Phase& phase = add(ticks, from_rate, from_rate / 2 + to_rate / 2);
    // (rate^2 - rate^2) / (2 ticks)
    const Scaled difference = scaled(to > from ? to - from : from - to);
    const Scaled size = difference * rate_of_root_ * rate_of_root_ / Scaled::of_word(ticks);
    const auto acceleration = static_cast<std::int64_t>(
        std::min(size.half().floor(acceleration_fraction_bits), largest_acceleration));
    phase.acceleration = to > from ? acceleration : -acceleration;
    phase.rate += static_cast<std::uint64_t>(phase.acceleration >> half_acceleration_shift);
  }

  Phase& add(std::uint32_t ticks, std::uint64_t rate, std::uint64_t mean_rate) {
    clocks_ += (Scaled::of_word(ticks, rate_fraction_bits) / Scaled::of(mean_rate)).floor();
    Phase& phase = profile_.phases[profile_.count++];
    phase.ticks = ticks;
    if (s_curve_in_image) phase.apex = 0;
    phase.rate = rate;
    phase.acceleration = 0;
    return phase;
  }

  void set_time(units::Hertz clock) {
    constexpr std::uint32_t second = 1'000'000;
    const std::uint32_t megahertz = clock.count() / second;
    if (clocks_ >> 32 == 0 && megahertz * second == clock.count()) {
      profile_.time = units::Microseconds(static_cast<std::uint32_t>(clocks_) / megahertz);
      return;
    }
    const Scaled time =
        Scaled::of(clocks_) * Scaled::of_word(second) / Scaled::of_word(clock.count());
    profile_.time = units::Microseconds(static_cast<std::int64_t>(time.floor()));
  }

 private:
  // False, and nothing done, where the ramp has to stay one of constant acceleration.
  bool add_s_curve(std::uint32_t ticks, std::uint64_t from, std::uint64_t to) {
    const std::optional<SCurve> curve = SCurve::between(ticks, from, to);
    if (!curve) return false;
    clocks_ += curve->clocks();
    Phase& phase = profile_.phases[profile_.count++];
    phase.ticks = ticks;
    phase.apex = curve->apex();
    phase.rate = from;
    phase.acceleration = static_cast<std::int64_t>(to - from);
    return true;
  }

  Scaled rate_of_root_;
  Profile& profile_;
  bool s_curve_;
  std::uint64_t clocks_{};
};

}  // namespace

[[gnu::noinline]] void make_profile(const Line& line, SpecificEnergy exit, units::Hertz clock,
                                    std::uint8_t min_cruise_percent, bool s_curve,
                                    Profile& profile) {
  const EnergyCourse course = course_of(line, exit, min_cruise_percent);
  Builder builder(line, s_curve, profile);
  profile.ticks = course.ticks;
  const std::uint32_t cruising = course.ticks - course.accelerating - course.braking;
  const std::uint64_t peak_rate = rate_of(line, course.peak);
  const auto ramp = [&](std::uint32_t ticks, SpecificEnergy from, SpecificEnergy to) {
    if (ticks == 0) return;
    if (from == to) {
      builder.add(ticks, peak_rate, peak_rate);
    } else if (to == course.peak) {
      builder.add_ramp(ticks, from, to, rate_of(line, from), peak_rate);
    } else {
      builder.add_ramp(ticks, from, to, peak_rate, rate_of(line, to));
    }
  };
  ramp(course.accelerating, course.entry, course.peak);
  if (cruising != 0) builder.add(cruising, peak_rate, peak_rate);
  ramp(course.braking, course.peak, course.exit);
  builder.set_time(clock);
}

}  // namespace motion
