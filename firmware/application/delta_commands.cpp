// SPDX-License-Identifier: Apache-2.0
// The geometry of a delta: M665 and M666. In the images of other machines nothing of it is called.
#include "application/setting_commands.hpp"
#include "motion/kinematics/delta_settings.hpp"

namespace application {
namespace {

using motion::kinematics::Delta;
using motion::kinematics::spatial_axes;
using units::Nanometers;

template <class Model>
Model model_of(const Delta::Parameters& parameters) {
  if constexpr (Model::may_be_delta) {
    return Model(parameters);
  } else {
    return {};
  }
}

void put(host_link::TextLine& line, char letter, std::int64_t millionths) {
  line.character(' ').character(letter).decimal(millionths, 6, 3);
}

}  // namespace

// A line with one value out of range changes nothing. S, segments per second, has no effect: lines
// are cut as finely as is needed.
Progress SettingCommands::set_geometry(ActiveCommand& command) {
  const Delta* delta = motion_.kinematics().delta();
  if (delta == nullptr) return command.report_not_fitted();
  Delta::Parameters changed = delta->parameters();
  const auto take = [&](char letter, Nanometers& length) {
    length = coordinates_.rounded_length(command.command, letter).value_or(length);
  };
  take('L', changed.rod);
  take('R', changed.radius);
  take('H', changed.height);
  for (std::size_t i = 0; i < spatial_axes; ++i) {
    take(static_cast<char>('A' + i), changed.rod_trim[i]);
    if (const auto degrees = command.command.value(units::axis_letters[i])) {
      // Clamped to what the check refuses.
      constexpr std::int64_t most = 1'000'000'000;
      changed.angle_trim[i] = static_cast<std::int32_t>(std::clamp(*degrees, -most, most));
    }
  }
  if (const auto fault = fault_of(changed); !fault.empty()) return command.refuse(fault);
  const bool moves_towers = changed.radius != delta->parameters().radius ||
                            changed.angle_trim != delta->parameters().angle_trim;
  if (moves_towers) place_towers(changed);
  change_geometry(changed);
  return Progress::done;
}

void SettingCommands::change_geometry(const Delta::Parameters& geometry) {
  if (geometry == motion_.kinematics().delta()->parameters()) return;
  motion::Limits limits = motion_.limits();
  limits.of(units::Axis::z).travel = geometry.height;
  motion_.change_geometry(model_of<motion::kinematics::Chosen>(geometry), limits);
  coordinates_.set_planned(motion_.position());
}

// Where it is as described, places stay known.
void SettingCommands::restore_geometry() {
  const motion::kinematics::Chosen described(machine_.kinematics);
  if (const Delta* delta = described.delta()) change_geometry(delta->parameters());
}

Progress SettingCommands::set_end_stop_offsets(ActiveCommand& command) {
  const Delta* delta = motion_.kinematics().delta();
  if (delta == nullptr) return command.report_not_fitted();
  Delta::Parameters changed = delta->parameters();
  for (std::size_t i = 0; i < spatial_axes; ++i) {
    Nanometers& offset = changed.end_stop_offset[i];
    offset = coordinates_.rounded_length(command.command, units::axis_letters[i]).value_or(offset);
  }
  if (const auto fault = fault_of(changed); !fault.empty()) return command.refuse(fault);
  motion_.set_kinematics(model_of<motion::kinematics::Chosen>(changed));
  return Progress::done;
}

// M665 or M666.
Progress SettingCommands::report_geometry(ActiveCommand& command) {
  if (motion_.kinematics().delta() == nullptr) return command.report_not_fitted();
  return command.say(geometry_report(command.command.code == 665));
}

// "echo: M665 L250.000 R105.000 H250.000 X0.000 Y0.000 Z0.000 A0.000 B0.000 C0.000" or
// "echo: M666 X0.000 Y0.000 Z0.000", three decimals: they are found by calibration.
host_link::TextLine SettingCommands::geometry_report(bool of_m665) const {
  const Delta::Parameters& delta = motion_.kinematics().delta()->parameters();
  host_link::TextLine line;
  const auto put_length = [&](char letter, Nanometers length) {
    put(line, letter, coordinates_.inches() ? length.count() * 10 / 254 : length.count());
  };
  line.text("echo: M").integer(of_m665 ? 665 : 666);
  if (of_m665) {
    put_length('L', delta.rod);
    put_length('R', delta.radius);
    put_length('H', delta.height);
  }
  for (std::size_t i = 0; i < spatial_axes; ++i) {
    if (of_m665) {
      put(line, units::axis_letters[i], delta.angle_trim[i]);
    } else {
      put_length(units::axis_letters[i], delta.end_stop_offset[i]);
    }
  }
  for (std::size_t i = 0; of_m665 && i < spatial_axes; ++i) {
    put_length(static_cast<char>('A' + i), delta.rod_trim[i]);
  }
  return line;
}

}  // namespace application
