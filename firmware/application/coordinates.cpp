// SPDX-License-Identifier: Apache-2.0
// Exact integer conversions of lengths, positions and feedrates.
#include "application/coordinates.hpp"

#include <algorithm>

#include "motion/limits.hpp"
#include "motion/steps.hpp"

namespace application {
namespace {

// Rounded to nearest, halves away from 0.
constexpr std::int64_t divided(std::int64_t value, std::int64_t divisor) {
  return (value < 0 ? value - divisor / 2 : value + divisor / 2) / divisor;
}

// A billionth of a millimetre is a picometre.
units::Position from_millimeters(const gcode::Number& number) {
  constexpr std::uint32_t nanometers_per_millimeter = 1'000'000;
  constexpr std::uint32_t picometers_per_nanometer = 1'000;
  const std::uint32_t nanometers = number.billionths / picometers_per_nanometer;
  const std::uint32_t picometers = number.billionths % picometers_per_nanometer;
  return {units::Nanometers(static_cast<std::int64_t>(
              std::uint64_t{number.whole} * nanometers_per_millimeter + nanometers)),
          picometers * 1'000};
}

// A billionth of an inch is 25 400 fm: 127 of 5000 parts of a nanometre, 200 fm each. In words,
// since a division of more takes hundreds of clocks.
units::Position from_inches(const gcode::Number& number) {
  constexpr std::uint32_t nanometers_per_inch = 25'400'000;
  constexpr std::uint32_t parts = 5'000, parts_per_billionth = 127;
  constexpr std::uint32_t femtometers_per_part = units::Position::femtometers_per_nanometer / parts;
  const std::uint32_t rest = number.billionths % parts * parts_per_billionth;
  const std::uint32_t nanometers = number.billionths / parts * parts_per_billionth + rest / parts;
  return {units::Nanometers(static_cast<std::int64_t>(
              std::uint64_t{number.whole} * nanometers_per_inch + nanometers)),
          rest % parts * femtometers_per_part};
}

// percent / 100 of a distance. Exact where the distance is one of G-code's: then it is a multiple
// of 200 fm. Down to a femtometre after a stop in mid-move.
units::Position scaled(const units::Position& distance, std::int32_t percent) {
  constexpr std::int64_t all = 100;
  constexpr std::uint32_t femtometers_per_part = units::Position::femtometers_per_nanometer / all;
  const std::int64_t parts = distance.whole().count() * percent;  // of all in a nanometre
  const std::int64_t rounded_down = parts >= 0 ? parts / all : (parts - (all - 1)) / all;
  const auto rest = static_cast<std::uint32_t>(parts - rounded_down * all);
  const std::uint64_t femtometers = static_cast<std::uint64_t>(distance.femtometers()) *
                                    static_cast<std::uint32_t>(percent) / all;
  return {units::Nanometers(rounded_down),
          rest * femtometers_per_part + static_cast<std::uint32_t>(femtometers)};
}

// `factor` is in 2^-32, at most 8. By the upper bits and the lower 16 of the distance, so that no
// product is too large.
units::Position multiplied(const units::Position& distance, std::uint64_t factor) {
  const bool back = distance < units::Position();
  const units::Position size = back ? -distance : distance;
  const auto whole = static_cast<std::uint64_t>(size.whole().count());
  const std::uint64_t low = (whole & 0xFFFF) * factor;
  const std::uint64_t high = (whole >> 16) * factor + (low >> 16);  // in 2^-16
  constexpr std::uint32_t nanometer = units::Position::femtometers_per_nanometer;
  const std::uint64_t femtometers = (((high & 0xFFFF) << 16) | (low & 0xFFFF)) * nanometer +
                                    static_cast<std::uint64_t>(size.femtometers()) * factor;
  const units::Position product{units::Nanometers(static_cast<std::int64_t>(high >> 16)),
                                static_cast<std::uint32_t>(femtometers >> 32)};
  return back ? -product : product;
}

}  // namespace

bool representable(const Positions& positions) { return motion::are_in_range(positions); }

void Coordinates::follow(const Positions& machine) {
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    units::Position distance = machine[i] - planned_[i];
    if (i == units::index_of(units::Axis::e) && volumetric()) {
      // Of less than 2 m of filament, which is more than a planner has.
      distance = units::Nanometers(distance.whole().count() * (std::int64_t{1} << 32) /
                                   static_cast<std::int64_t>(feed().length_of_volume));
    }
    logical_[i] += distance;
  }
  planned_ = machine;
}

void Coordinates::set_filament(std::size_t tool, units::Nanometers diameter) {
  feeds_[tool].filament = diameter;
  volumetric_ = diameter.count() != 0;
  if (!volumetric_) return;
  // 4 / (pi d^2), d in um
  constexpr std::uint64_t four_by_pi = 2'935'890'503'282'001'226;  // in 2^-61
  const auto micrometers = static_cast<std::uint32_t>(diameter.count() / nanometers_per_micrometer);
  feeds_[tool].length_of_volume =
      (four_by_pi / (std::uint64_t{micrometers} * micrometers) * 1'000'000) >> 29;
}

void Coordinates::add_origins(bool subtract) {
  for (std::size_t i = 0; i < Workspaces::axes; ++i) {
    const units::Position origin = workspaces_.origin(i);
    logical_[i] += subtract ? -origin : origin;
  }
}

void Coordinates::rename_place(units::Axis axis, const units::Position& position) {
  const std::size_t i = units::index_of(axis);
  if (i < Workspaces::axes) workspaces_.shift(i, position - logical_[i]);
  logical_[i] = position;
  if (axis == units::Axis::z) z_is_set_ = true;
}

void Coordinates::axis_homed(units::Axis axis, const units::Position& machine) {
  const std::size_t i = units::index_of(axis);
  workspaces_.axis_homed(i);
  if (axis == units::Axis::z) {
    babystep_ = pending_babystep_ = {};
    z_is_set_ = true;
  }
  logical_[i] = machine + workspaces_.origin(i);
  if (units::most_tools > 1 && i < std::tuple_size_v<ToolOffset>) logical_[i] += tool_offset(i);
}

void Coordinates::select_tool(std::size_t tool) {
  if constexpr (units::most_tools > 1) {
    for (std::size_t i = 0; i < std::tuple_size_v<ToolOffset>; ++i) {
      logical_[i] += tools_.offset(tool)[i] - tool_offset(i);
    }
    tools_.select(tool);
  }
}

void Coordinates::restore_tools(const MachineDescription& machine) {
  if constexpr (units::most_tools > 1) {
    const ToolOffset before = tools_.offset(tool());
    tools_.restore(machine);
    for (std::size_t i = 0; i < before.size(); ++i) logical_[i] += tool_offset(i) - before[i];
  }
}

void Coordinates::set_tool_offset(std::size_t tool, std::size_t axis, units::Nanometers offset) {
  if (tool == this->tool()) logical_[axis] += offset - tool_offset(axis);
  tools_.offset(tool)[axis] = offset;
}

std::optional<units::Position> Coordinates::length(const gcode::Command& command,
                                                   char letter) const {
  const auto number = command.number(letter);
  if (!number) return std::nullopt;
  const units::Position size = inches_ ? from_inches(*number) : from_millimeters(*number);
  return number->negative ? -size : size;
}

std::optional<units::Nanometers> Coordinates::rounded_length(const gcode::Command& command,
                                                             char letter) const {
  const auto exact = length(command, letter);
  return exact ? std::optional(exact->nearest()) : std::nullopt;
}

void Coordinates::put_target_of(const gcode::Command& command, Positions& target) const {
  target = logical_;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    const auto value = length(command, units::axis_letters[i]);
    if (!value) continue;
    const bool extruder = i == units::index_of(units::Axis::e);
    const bool relative = extruder ? extruder_relative_ : axes_relative_;
    target[i] = relative ? logical_[i] + *value : *value;
    if (command.in_machine_coordinates && !relative && !extruder) {
      target[i] += workspaces_.origin(i);
    }
  }
}

void Coordinates::put_machine_target(const Positions& target, const Positions& machine,
                                     Positions& result) const {
  result = machine;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    if (target[i] == logical_[i]) continue;
    units::Position distance = target[i] - logical_[i];
    if (i == units::index_of(units::Axis::e) && flow(tool()) != 100) {
      distance = scaled(distance, flow(tool()));
    }
    if (i == units::index_of(units::Axis::e) && volumetric()) {
      distance = multiplied(distance, feed().length_of_volume);
    }
    result[i] += distance;
  }
}

void Coordinates::take_feedrate(const gcode::Command& command) {
  const auto per_minute = rounded_length(command, 'F');
  if (!per_minute || per_minute->count() <= 0) return;
  const std::int64_t speed = divided(per_minute->count(), motion::nanometers_per_minute);
  feedrate_ = units::MicrometersPerSecond(
      static_cast<std::int32_t>(std::clamp<std::int64_t>(speed, 1, motion::max_speed.count())));
}

units::MicrometersPerSecond Coordinates::feedrate() const {
  if (planned_percent_ == 100) return feedrate_;
  const std::int64_t speed = divided(std::int64_t{feedrate_.count()} * planned_percent_, 100);
  return units::MicrometersPerSecond(
      static_cast<std::int32_t>(std::clamp<std::int64_t>(speed, 1, motion::max_speed.count())));
}

}  // namespace application
