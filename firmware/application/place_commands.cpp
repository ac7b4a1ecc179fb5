// SPDX-License-Identifier: Apache-2.0
// Straight moves whose targets are places of the machine.
#include "application/place_commands.hpp"

#include <algorithm>

namespace application {

using units::Axis;
using units::index_of;
using units::Nanometers;
using units::Position;

namespace {

constexpr std::size_t z = index_of(Axis::z);
constexpr std::size_t e = index_of(Axis::e);

// Marlin's NOZZLE_PARK_POINT and its feedrate.
constexpr Nanometers park_border{10'000'000};
constexpr Nanometers park_height{20'000'000};
constexpr units::MicrometersPerSecond park_speed{100'000};

}  // namespace

// The host's coordinates change by as much as the machine's.
Progress PlaceCommands::append(ActiveCommand& command, const Positions& machine,
                               units::MicrometersPerSecond feedrate) {
  if (const auto refused = moves_.refuse_beyond_limits(command, machine)) return *refused;
  const Positions before = motion_.position();
  const auto accepted = motion_.append({.target = machine, .feedrate = feedrate});
  if (!accepted) return command.refuse(motion::describe(accepted.error()));
  for (std::size_t i = 0; i < e; ++i) {
    coordinates_.set_logical(static_cast<Axis>(i),
                             coordinates_.logical()[i] + (machine[i] - before[i]));
  }
  coordinates_.set_planned(motion_.position());
  return Progress::done;
}

Progress PlaceCommands::park(ActiveCommand& command) {
  Positions target = motion_.position();
  if (command.phase == ActiveCommand::Phase::begin) {
    for (const Axis axis : {Axis::x, Axis::y, Axis::z}) {
      if (!motion_.homed().contains(axis)) return command.refuse("Home XYZ first");
    }
    // A delta's travel is not by axes.
    if (motion_.limits().of(Axis::x).travel < park_border) {
      return command.refuse("No place to park");
    }
    const auto manner = command.integer('P').value_or(0);
    const Position high(std::min(park_height, motion_.limits().of(Axis::z).travel));
    if (manner == 2) {
      target[z] = std::min(target[z] + Position(park_height),
                           Position(motion_.limits().of(Axis::z).travel));
    } else if (manner == 1 || target[z] < high) {
      target[z] = high;
    }
    jumps_ = motion_.position_jumps();
    const Progress lifted = append(command, target, motion_.limits().of(Axis::z).max_speed);
    if (command.refused) return lifted;
    command.phase = ActiveCommand::Phase::appending;
    return Progress::again;
  }
  if (motion_.stopping() || motion_.position_jumps() != jumps_) return Progress::done;
  if (!motion_.has_room()) return Progress::again;
  target[index_of(Axis::x)] = Position(std::min(park_border, motion_.limits().of(Axis::x).travel));
  target[index_of(Axis::y)] =
      Position(std::max(motion_.limits().of(Axis::y).travel - park_border, Nanometers()));
  return append(command, target, park_speed);
}

Progress PlaceCommands::save_position(ActiveCommand& command) {
  const auto slot = static_cast<std::size_t>(command.integer('S').value_or(0));
  Positions& place = places_[slot];
  place = coordinates_.logical();
  for (std::size_t i = 0; i < e; ++i) place[i] = place[i] - coordinates_.workspaces().origin(i);
  saved_ = static_cast<std::uint8_t>(saved_ | 1u << slot);
  return Progress::done;
}

Progress PlaceCommands::restore_position(ActiveCommand& command) {
  const auto slot = static_cast<std::size_t>(command.integer('S').value_or(0));
  if ((saved_ >> slot & 1u) == 0) return command.refuse("No position saved in this slot");
  units::AxisSet axes = command.named_axes();
  if (axes.empty()) axes = units::AxisSet::all();
  Positions target = motion_.position();
  for (std::size_t i = 0; i < e; ++i) {
    if (!axes.contains(static_cast<Axis>(i))) continue;
    const auto added = coordinates_.length(command.command, units::axis_letters[i]);
    target[i] += places_[slot][i] + coordinates_.workspaces().origin(i) -
                 coordinates_.logical()[i] + added.value_or(Position());
  }
  const units::MicrometersPerSecond before = coordinates_.kept_feedrate();
  coordinates_.take_feedrate(command.command);
  const Progress progress = append(command, target, coordinates_.feedrate());
  if (command.refused) {
    coordinates_.keep_feedrate(before);
  } else if (axes.contains(Axis::e)) {
    coordinates_.set_logical(Axis::e, places_[slot][e]);
  }
  return progress;
}

Progress PlaceCommands::step_baby(ActiveCommand& command) {
  constexpr Nanometers farthest{2'000'000};  // Marlin's
  const char letter = command.command.has_number('Z') ? 'Z' : 'S';
  const auto asked = coordinates_.rounded_length(command.command, letter);
  const Position step(std::clamp(asked.value_or(Nanometers()), -farthest, farthest));
  Positions target = motion_.position();
  target[z] += coordinates_.pending_babystep() + step;
  if (const auto refused = moves_.refuse_beyond_limits(command, target)) return *refused;
  const bool at_once = motion_.at_rest();
  if (at_once) {
    const auto accepted =
        motion_.append({.target = target, .feedrate = motion_.limits().of(Axis::z).max_speed});
    if (!accepted) return command.refuse(motion::describe(accepted.error()));
    motion_.flush();
    coordinates_.set_planned(motion_.position());
  }
  coordinates_.add_babystep(step);
  if (at_once) coordinates_.babystep_made();
  return Progress::done;
}

// "echo:Babystep Z:0.050"
Progress PlaceCommands::report_babystep(ActiveCommand& command) {
  host_link::TextLine line;
  line.text("echo:Babystep Z:");
  return command.say(line.decimal(coordinates_.babystep().nearest().count(), 6, 3));
}

}  // namespace application
