// SPDX-License-Identifier: Apache-2.0
// Lines above an uneven bed, chord by chord, and the moves of the probe.
#include <algorithm>

#include "application/motion_task.hpp"
#include "units/loop_bound.hpp"

namespace application {
namespace {

constexpr std::size_t z = units::index_of(units::Axis::z);

// Near the end of reach so many chords of a line are looked at; it is refused with more.
constexpr std::uint32_t most_chords = 512;

}  // namespace

// Whether all of its chords are within reach with what the mesh adds.
bool MotionTask::reaches_levelled(const motion::LineMove& move, std::uint32_t chords) {
  motion::Levelling& levelling = *levelling_;
  // A line that is within reach is so all along. Nowhere does the mesh add more than this to it.
  const auto added = [&](const units::PerAxis<units::Position>& place) {
    return levelling.mesh.faded(motion::BedMesh::most_height, place[z]);
  };
  const units::Nanometers most = std::max(added(levelling.place), added(move.target));
  const auto reaches = [&](units::PerAxis<units::Position> place, units::Nanometers correction) {
    place[z] += correction;
    return kinematics().reaches(place);
  };
  if (reaches(levelling.place, most) && reaches(move.target, most) &&
      reaches(levelling.place, -most) && reaches(move.target, -most)) {
    return true;
  }
  levelling.line.begin(levelling.mesh, levelling.place, move, chords);
  bool within = true;
  units::LoopBound<most_chords> looked_at;
  for (std::uint32_t i = 0; within && !levelling.line.done() && i < most_chords; ++i) {
    looked_at.next();
    within = kinematics().reaches(levelling.line.next(levelling.mesh).target);
  }
  within = within && levelling.line.done();
  levelling.line.cancel();
  return within;
}

std::expected<void, motion::Fault> MotionTask::append_levelled(motion::LineMove move) {
  using motion::LevelledLine;
  motion::Levelling& levelling = *levelling_;
  if (!LevelledLine::can_be(levelling.place, move.target)) {
    return std::unexpected(motion::Fault::line_too_long);
  }
  std::uint32_t chords = 1;
  if (!kinematics().straight()) {
    if (const auto limited = limit_to_mechanism(move); !limited) return limited;
    chords = kinematics().chords(levelling.place, move.target);
    if (!reaches_levelled(move, chords)) return std::unexpected(motion::Fault::mesh_out_of_reach);
  }
  levelling.line.begin(levelling.mesh, levelling.place, move, chords);
  const auto accepted = append_line(levelling.line.next(levelling.mesh));
  if (!accepted) {
    levelling.line.cancel();
    return accepted;
  }
  levelling.place = move.target;
  levelling.line_is_before_stretch = false;
  return accepted;
}

// All of them are within reach, and none is refused for want of room.
void MotionTask::go_on_levelled() {
  motion::LevelledLine& line = levelling_->line;
  const std::size_t lines = planner_.lines();
  if (!append_line(line.next(levelling_->mesh))) return quick_stop();
  if (stretch_behind_ && levelling_->line_is_before_stretch) {
    lines_before_ += planner_.lines() - lines;
  }
  if (line.done() && line.flushes()) planner_.flush();
}

void MotionTask::stop_levelling() {
  if (!levelling_->active) return;
  levelling_->active = false;
  ++position_jumps_;
}

bool MotionTask::begin_levelling() {
  if (!levelling_->mesh.complete() || !levelling_->mesh.fades_slowly()) return false;
  levelling_->active = true;
  find_levelled_place();
  ++position_jumps_;
  return true;
}

// From where the nozzle is.
void MotionTask::find_levelled_place() {
  levelling_->place = planner_.position();
  levelling_->place[z] = levelling_->mesh.uncorrected_z(planner_.position());
}

void MotionTask::restore_levelling() {
  const motion::LevellingSettings& settings = *machine_.levelling;
  stop_levelling();
  levelling_->probe = settings.probe;
  levelling_->mesh.set_axes(settings.mesh.axes);
  levelling_->mesh.set_fade_height(settings.mesh.fade_height);
}

std::uint8_t MotionTask::probe_input() const {
  return static_cast<std::uint8_t>(1u << machine_.levelling->probe.input);
}

void MotionTask::start_probing(units::Nanometers x, units::Nanometers y) {
  levelling_->probing.start(levelling_->probe, x, y);
}

void MotionTask::lead_probing() {
  motion::Probing& probing = levelling_->probing;
  const auto move = probing.update({.stopped = stopped_by_end_stop_,
                                    .triggered = probe_triggered(),
                                    .place = planner_.position()});
  if (!move) {
    ++position_jumps_;  // the host's coordinates have not seen its last moves
    return;
  }
  stopped_by_end_stop_ = false;
  const std::uint8_t mask = move->stops ? probe_input() : std::uint8_t{};
  const auto accepted =
      append({.target = move->target, .feedrate = move->speed, .stop_mask = mask});
  if (!accepted) probing.cancel();
  flush();
}

}  // namespace application
