// SPDX-License-Identifier: Apache-2.0
// Commands that wait for the end of all motion: homing, probing, stops, and other steps.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "sim/report/point_check.hpp"

namespace report {

namespace {

// From where its end stop switches, where homing ends: filter and reaction take a few.
constexpr std::int64_t furthest_home_steps = 40;
constexpr std::size_t extruder = 3;

}  // namespace

// The chip comes to rest before.
void PointCheck::set_shaping() {
  judge_states_until(std::numeric_limits<sim::Clock>::max());
  judges_.now().settle(true);
  const Steps meant = judges_.now().last_target();
  add_missed(judges_.now().take_missed(), judged_);
  judges_.set_shaping(gcode_.shaping());
  babystep_.reset();
  judges_.now().restart(state_, meant);
}

void PointCheck::take_up(const NewPlay& play) {
  taken_up_ = play;
  judges_.set_play_mm(std::hypot(millimeters(play.lengths[0]), millimeters(play.lengths[1])));
  for (std::size_t i = 0; i < play.lengths.size(); ++i) {
    play_.set_play(i, nearest_step(play.lengths[i], grid_.resolution()[i]));
  }
}

// As a line that ends where the nozzle is to be then.
void PointCheck::finish_probing(const Probing& probing, const SentCommand& command) {
  const Steps end = grid_.steps_at(probing.nozzle);
  judges_.now().restart(state_, end);
  const Move stay{.from = probing.nozzle, .to = probing.nozzle, .arc = {}};
  judges_.now().ask(stay, {command.file_line, command.text}, end, std::nullopt);
  judges_.now().settle(true);
}

void PointCheck::finish_homing(const Homing& homing) {
  Steps meant = judges_.now().last_target();
  if (grid_.mechanism().is_cartesian()) {
    for (std::size_t i = 0; i < homing.axes.size(); ++i) {
      if (!homing.axes[i]) continue;
      judged_.homed_elsewhere[i] =
          judged_.homed_elsewhere[i] || std::llabs(state_.position[i]) > furthest_home_steps;
      grid_.set_origin(i, 0);
      state_.position[i] = play_.push_back(i);
      meant[i] = 0;
    }
  } else {
    meant = home_motors(homing);
  }
  judges_.now().restart(state_, meant);
  homed_ = true;
  judges_.set_grid(grid_);
}

// The axes that were not homed are where they were. Where both motors of a switch make a step at a
// time, it may close half a step late.
Steps PointCheck::home_motors(const Homing& homing) {
  const auto real =
      MotorGrid(grid_.shared_mechanism(), grid_.resolution(), {}).place_mm(state_.position);
  const Point& meant = gcode_.position();
  for (std::size_t i = 0; i < homing.axes.size(); ++i) {
    if (!homing.axes[i]) continue;
    const double off = std::abs(real[i] - millimeters(meant[i]));
    judged_.homed_elsewhere[i] =
        judged_.homed_elsewhere[i] || off * grid_.steps_per_mm(i) > furthest_home_steps;
  }
  grid_.move_origin(meant, state_.position);
  return grid_.steps_at(meant);
}

// The place in millimetres stays what it is.
void PointCheck::change_resolution(const NewResolution& resolution) {
  const Steps before = grid_.steps_at(gcode_.nozzle());
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (const auto value = resolution.steps_per_mm[std::min(i, extruder)]; value && *value > 0) {
      grid_.set_resolution(i, *value);
      const Steps now = grid_.steps_at(gcode_.nozzle());
      grid_.set_origin(i, grid_.origin()[i] + before[i] - now[i]);
    }
  }
  take_up(taken_up_);
  judges_.set_grid(grid_);
}

void PointCheck::stop_here() {
  gcode_.stop_at(grid_.place_of_steps(state_.position));
  judges_.now().restart(state_, state_.position);
}

}  // namespace report
