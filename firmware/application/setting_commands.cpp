// SPDX-License-Identifier: Apache-2.0
// The commands that change what the axes may do, how often what is said, and the program itself:
// M86 M92 M113 M154 M155 M201 M203 M204 M205 M997.
#include <algorithm>
#include <limits>

#include "application/command_executor.hpp"
#include "host_link/replies.hpp"
#include "platform/boot_loader.hpp"

namespace application {
namespace {

constexpr std::int64_t nanometers_per_micrometer = 1000;

// Beyond the range of the type it becomes a value that the setting refuses.
template <class Quantity>
Quantity micrometers(units::Nanometers length) {
  using Representation = typename Quantity::Representation;
  constexpr std::int64_t most = std::numeric_limits<Representation>::max();
  const std::int64_t value = length.count() / nanometers_per_micrometer;
  return Quantity(static_cast<Representation>(std::clamp(value, -most, most)));
}

}  // namespace

// All axes or none: a line with one value out of range changes nothing.
template <class Quantity>
CommandExecutor::Progress CommandExecutor::set_per_axis(motion::Accepted (*set)(motion::Limits&,
                                                                                units::Axis,
                                                                                Quantity)) {
  motion::Limits changed = motion_.limits();
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    const auto value = coordinates_.rounded_length(command_, units::axis_letters[i]);
    if (!value) continue;
    const auto accepted = set(changed, static_cast<units::Axis>(i), micrometers<Quantity>(*value));
    if (!accepted) return refuse(motion::describe(accepted.error()));
  }
  motion_.set_limits(changed);
  return Progress::done;
}

CommandExecutor::Progress CommandExecutor::set_for_all(std::span<const Setting> settings) {
  motion::Limits changed = motion_.limits();
  for (const Setting& setting : settings) {
    const auto value = coordinates_.rounded_length(command_, setting.letter);
    if (!value) continue;
    const motion::Accepted accepted = setting.set(changed, *value);
    if (!accepted) return refuse(motion::describe(accepted.error()));
  }
  motion_.set_limits(changed);
  return Progress::done;
}

CommandExecutor::Progress CommandExecutor::set_max_accelerations() {
  if (named_axes().empty()) return report_setting();
  return set_per_axis(motion::set_max_acceleration);
}

CommandExecutor::Progress CommandExecutor::set_max_speeds() {
  if (named_axes().empty()) return report_setting();
  return set_per_axis(motion::set_max_speed);
}

// P printing, T travel, R retraction; S is both P and T, as old slicers write it.
CommandExecutor::Progress CommandExecutor::set_accelerations() {
  if (!has_any("PRTS")) return report_setting();
  using Acceleration = units::MicrometersPerSecondSquared;
  constexpr auto print = [](motion::Limits& limits, units::Nanometers value) {
    return motion::set_print_acceleration(limits, micrometers<Acceleration>(value));
  };
  constexpr auto travel = [](motion::Limits& limits, units::Nanometers value) {
    return motion::set_travel_acceleration(limits, micrometers<Acceleration>(value));
  };
  constexpr auto retract = [](motion::Limits& limits, units::Nanometers value) {
    return motion::set_retract_acceleration(limits, micrometers<Acceleration>(value));
  };
  static constexpr Setting settings[]{
      {'S', print}, {'S', travel}, {'P', print}, {'T', travel}, {'R', retract}};
  return set_for_all(settings);
}

// X Y Z E jerk, S slowest print move, T slowest travel; B and J (other planners' numbers) are
// ignored.
CommandExecutor::Progress CommandExecutor::set_advanced() {
  if (!has_any("XYZESTBJ")) return report_setting();
  using Speed = units::MicrometersPerSecond;
  constexpr auto print = [](motion::Limits& limits, units::Nanometers value) {
    return motion::set_min_print_speed(limits, micrometers<Speed>(value));
  };
  constexpr auto travel = [](motion::Limits& limits, units::Nanometers value) {
    return motion::set_min_travel_speed(limits, micrometers<Speed>(value));
  };
  static constexpr Setting settings[]{{'S', print}, {'T', travel}};
  if (has_any("XYZE")) {
    if (set_per_axis(motion::set_jerk) == Progress::again) return Progress::again;
    if (refused_) return Progress::done;
  }
  return set_for_all(settings);
}

// The position in millimetres is kept, as in Marlin.
CommandExecutor::Progress CommandExecutor::set_steps_per_millimeter() {
  if (named_axes().empty()) return report_setting();
  if (wait_for_rest() == Progress::again) return Progress::again;
  motion::Limits changed = motion_.limits();
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    const auto value = command_.value(units::axis_letters[i]);
    if (!value) continue;
    constexpr std::int64_t millionths_per_thousandth = 1000;
    if (*value % millionths_per_thousandth != 0) return refuse("More than three decimals");
    const std::int64_t per_meter = std::clamp<std::int64_t>(
        *value / millionths_per_thousandth, 0, std::numeric_limits<std::int32_t>::max());
    const auto accepted =
        motion::set_steps_per_meter(changed, static_cast<units::Axis>(i),
                                    units::StepsPerMeter(static_cast<std::int32_t>(per_meter)));
    if (!accepted) return refuse(motion::describe(accepted.error()));
  }
  motion_.set_steps_per_meter(changed);
  planned_ = motion_.position();
  return Progress::done;
}

// S in seconds, cut to what makes sense; without S nothing changes.
CommandExecutor::Progress CommandExecutor::set_interval(units::Milliseconds& interval,
                                                        std::int64_t longest_s) {
  if (const auto seconds = command_.integer('S')) {
    interval = units::Milliseconds(std::clamp<std::int64_t>(*seconds, 0, longest_s) * 1000);
  }
  return Progress::done;
}

CommandExecutor::Progress CommandExecutor::tell_interval(units::Milliseconds interval) {
  host_link::TextLine line;
  line.text("echo:M").integer(command_.code).text(" S");
  return say(line.integer(interval.count() / 1000));
}

CommandExecutor::Progress CommandExecutor::set_busy_interval() {
  constexpr std::int64_t longest_s = 60;
  if (!command_.has('S')) return tell_interval(busy_interval_);
  set_interval(busy_interval_, longest_s);
  link_.set_busy_interval(busy_interval_);
  return Progress::done;
}

CommandExecutor::Progress CommandExecutor::set_host_silence() {
  constexpr std::int64_t longest_s = 24 * 3600;
  if (!command_.has('S')) return tell_interval(host_silence_);
  return set_interval(host_silence_, longest_s);
}

// The loader answers from then on; control does not return here.
CommandExecutor::Progress CommandExecutor::update_firmware() {
  if (wait_for_rest() == Progress::again) return Progress::again;
  if (platform::enter_boot_loader()) return Progress::done;
  return refuse("No boot loader in this image");
}

}  // namespace application
