// SPDX-License-Identifier: Apache-2.0
// G29 and G30: places to probe, one after another.
#include <algorithm>

#include "application/levelling_commands.hpp"
#include "application/levelling_reports.hpp"
#include "motion/limits.hpp"
#include "units/loop_bound.hpp"

namespace application {

using units::Axis;
using units::Nanometers;

namespace {

constexpr std::array spatial_axes{Axis::x, Axis::y, Axis::z};

}  // namespace

// A place of the host's coordinates in the machine's.
std::optional<Nanometers> LevellingCommands::machine_length(const gcode::Command& command,
                                                            char letter, Axis axis) const {
  const auto length = coordinates_.length(command, letter);
  if (!length) return std::nullopt;
  const std::size_t i = units::index_of(axis);
  return (*length - coordinates_.logical()[i] + motion_.position()[i]).nearest();
}

// Of the nozzle with the probe there, at the height at which it travels.
Positions LevellingCommands::above(Nanometers x, Nanometers y) const {
  const motion::ProbeSettings& probe = motion_.levelling().probe;
  Positions nozzle = motion_.position();
  nozzle[0] = x - probe.offset[0];
  nozzle[1] = y - probe.offset[1];
  nozzle[2] = probe.clearance;
  return nozzle;
}

// Where the nozzle is, and the way from `from`.
bool LevellingCommands::reaches(const Positions& from, const Positions& nozzle) const {
  for (const Axis axis : spatial_axes) {
    const Nanometers travel = motion_.limits().of(axis).travel;
    const Nanometers place = nozzle[units::index_of(axis)].nearest();
    if (travel > Nanometers() && (place < Nanometers() || travel < place)) return false;
  }
  return motion_.kinematics().reaches(nozzle) && motion_.kinematics().straight_within(from, nozzle);
}

// Every point in the order of probing, before the first one.
std::optional<Progress> LevellingCommands::refuse_unreached(
    ActiveCommand& command, const std::array<motion::MeshAxis, 2>& axes) const {
  const std::size_t columns = axes[0].points, rows = axes[1].points;
  // Where travels are all that bounds the axes, corners tell.
  const bool corners = motion_.kinematics().straight();
  Positions from = motion_.position();
  from[2] = std::max(from[2], units::Position(motion_.levelling().probe.clearance));
  units::LoopBound<motion::BedMesh::most_points> bound;
  for (std::size_t row = 0; row < rows; row += corners ? rows - 1 : 1) {
    bound.next();
    units::LoopBound<motion::BedMesh::most_points, 1> points;
    for (std::size_t i = 0; i < columns; i += corners ? columns - 1 : 1) {
      points.next();
      const std::size_t column = row % 2 == 0 ? i : columns - 1 - i;
      const Nanometers x = axes[0].line(column), y = axes[1].line(row);
      const Positions nozzle = above(x, y);
      if (reaches(from, nozzle)) {
        from = nozzle;
        continue;
      }
      host_link::TextLine line;
      line.text("The probe does not reach");
      for (const std::size_t axis : {0UZ, 1UZ}) {
        const units::Position place =
            coordinates_.logical()[axis] - motion_.position()[axis] + (axis == 0 ? x : y);
        line.character(' ').character(units::axis_letters[axis]);
        line.decimal(place.nearest().count(), 6, 2);
      }
      return command.refuse(line.text(" in a straight line: change L R F B or X Y").view());
    }
  }
  return std::nullopt;
}

// Where an axis may be anywhere, the way down could be one into the bed.
std::optional<Progress> LevellingCommands::refuse_to_probe(ActiveCommand& command) const {
  for (const Axis axis : spatial_axes) {
    if (!motion_.located().contains(axis)) return command.refuse("Home XYZ first");
  }
  return std::nullopt;
}

std::optional<Progress> LevellingCommands::failure(ActiveCommand& command) const {
  const motion::Probing& probing = motion_.levelling().probing;
  if (probing.fault()) return command.end_everything({Fatal::Reason::probing, {}, Axis::z});
  if (!probing.result()) return command.refuse("Probing was stopped");
  return refuse_after_stop(command);
}

std::optional<Progress> LevellingCommands::refuse_after_stop(ActiveCommand& command) const {
  for (const Axis axis : spatial_axes) {
    if (!motion_.located().contains(axis)) return command.refuse("Probing was stopped");
  }
  return std::nullopt;
}

std::size_t LevellingCommands::column() const {
  const std::size_t along = point_ % points(0);
  return row() % 2 == 0 ? along : points(0) - 1 - along;
}

// Why not, or nothing.
std::optional<std::string_view> LevellingCommands::take_grid(
    const gcode::Command& command, std::array<motion::MeshAxis, 2>& axes) const {
  constexpr std::array<std::string_view, 2> letters{"LR", "FB"};
  constexpr Nanometers least_span{1'000'000}, most_span{2'000'000'000};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto axis = static_cast<Axis>(i);
    const std::int64_t count = command.integer(units::axis_letters[i]).value_or(axes[i].points);
    if (count < 2 || count > static_cast<std::int64_t>(motion::BedMesh::most_points)) {
      return "X or Y not within 2 to 15 points";
    }
    axes[i].points = static_cast<std::uint8_t>(count);
    axes[i].first = machine_length(command, letters[i][0], axis).value_or(axes[i].first);
    axes[i].last = machine_length(command, letters[i][1], axis).value_or(axes[i].last);
    const Nanometers span = axes[i].last - axes[i].first;
    if (span < least_span || span > most_span) return "R must be right of L, and B behind F";
  }
  return std::nullopt;
}

Progress LevellingCommands::begin_grid(ActiveCommand& command) {
  if (const auto refused = refuse_to_probe(command)) return *refused;
  auto axes = motion_.fitted_levelling().mesh.axes;
  if (const auto reason = take_grid(command.command, axes)) return command.refuse(*reason);
  if (const auto refused = refuse_unreached(command, axes)) return *refused;
  const auto speed = coordinates_.rounded_length(command.command, 'S');
  if (speed && *speed < Nanometers(motion::nanometers_per_minute)) {
    return command.refuse("S must be above 0");
  }
  motion_.change_levelling(false, [&](motion::Levelling& levelling) {
    levelling.mesh.set_axes(axes);
    levelling.probe.travel_speed = motion_.fitted_levelling().probe.travel_speed;
    if (!speed) return;
    levelling.probe.travel_speed =
        units::MicrometersPerSecond(static_cast<std::int32_t>(std::min<std::int64_t>(
            speed->count() / motion::nanometers_per_minute, motion::max_speed.count())));
  });
  point_ = 0;
  point_begun_ = false;
  command.phase = ActiveCommand::Phase::working;
  return Progress::again;
}

Progress LevellingCommands::begin_point(ActiveCommand& command) {
  if (const auto stopped = refuse_after_stop(command)) return *stopped;
  const motion::BedMesh& mesh = motion_.levelling().mesh;
  if (command.command.integer('V').value_or(0) > 0) {
    host_link::TextLine line;
    line.text("Probing mesh point ").integer(static_cast<std::int64_t>(point_ + 1));
    line.character('/').integer(static_cast<std::int64_t>(points(0) * points(1))).character('.');
    if (command.say(line) == Progress::again) return Progress::again;
  }
  motion_.start_probing(mesh.line(0, column()), mesh.line(1, row()));
  point_begun_ = true;
  return Progress::again;
}

Progress LevellingCommands::probe_bed(ActiveCommand& command) {
  if (command.phase == ActiveCommand::Phase::begin) return begin_grid(command);
  if (point_ == points(0) * points(1)) return end_grid(command);
  if (!point_begun_) return begin_point(command);
  const motion::Probing& probing = motion_.levelling().probing;
  if (probing.active() || !motion_.at_rest()) return Progress::again;
  if (const auto failed = failure(command)) return *failed;
  bool plausible = true;
  motion_.change_levelling(false, [&](motion::Levelling& levelling) {
    plausible = levelling.mesh.set_height(column(), row(), *probing.result());
  });
  if (!plausible) return command.end_everything({Fatal::Reason::probing, {}, Axis::z});
  ++point_;
  point_begun_ = false;
  return Progress::again;
}

Progress LevellingCommands::end_grid(ActiveCommand& command) {
  if (const auto stopped = refuse_after_stop(command)) return *stopped;
  if (say_mesh(command) == Progress::again) return Progress::again;
  return motion_.change_levelling(true, [](motion::Levelling&) {}) ? Progress::done
                                                                   : refuse_to_follow(command);
}

Progress LevellingCommands::probe_place(ActiveCommand& command) {
  const motion::Probing& probing = motion_.levelling().probing;
  if (command.phase == ActiveCommand::Phase::begin) {
    if (const auto refused = refuse_to_probe(command)) return *refused;
    std::array<Nanometers, 2> place;
    for (std::size_t i = 0; i < place.size(); ++i) {
      place[i] =
          machine_length(command.command, units::axis_letters[i], static_cast<Axis>(i))
              .value_or(motion_.position()[i].nearest() + motion_.levelling().probe.offset[i]);
    }
    Positions from = motion_.position();
    from[2] = std::max(from[2], units::Position(motion_.levelling().probe.clearance));
    if (!reaches(from, above(place[0], place[1]))) {
      return command.refuse("The probe does not reach X and Y");
    }
    motion_.change_levelling(false, [](motion::Levelling&) {});
    motion_.start_probing(place[0], place[1]);
    command.phase = ActiveCommand::Phase::working;
    return Progress::again;
  }
  if (probing.active() || !motion_.at_rest()) return Progress::again;
  if (const auto failed = failure(command)) return *failed;
  host_link::TextLine line;
  const auto put = [&](char letter, units::Position place) {
    line.character(' ').character(letter).text(": ").decimal(place.nearest().count(), 6, 2);
  };
  line.text("Bed");
  for (std::size_t i = 0; i < 2; ++i) {
    const Nanometers machine = i == 0 ? probing.x() : probing.y();
    put(units::axis_letters[i], coordinates_.logical()[i] - motion_.position()[i] + machine);
  }
  put('Z', *probing.result());
  return command.say(line);
}

}  // namespace application
