// SPDX-License-Identifier: Apache-2.0
// From commands and edges to points and states, in the order in which they came about.
#include "sim/report/point_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace report {

namespace {

constexpr std::size_t most_listed = 1000;
// From where its end stop switches, where homing ends: filter and reaction take a few.
constexpr std::int64_t furthest_home_steps = 40;
constexpr std::size_t extruder = 3;

double length_of(const Move& move) {
  std::array<double, 3> way{};
  for (std::size_t i = 0; i < way.size(); ++i) way[i] = millimeters(move.to[i] - move.from[i]);
  if (move.arc) {
    way[move.arc->first] = move.arc->length_mm();
    way[move.arc->second] = 0;
  }
  return std::hypot(way[0], way[1], way[2]);
}

}  // namespace

PointCheck::PointCheck(const std::array<double, 4>& steps_per_mm, const Steps& start,
                       sim::ClockRate rate, const MachineFacts& machine,
                       std::shared_ptr<const machine::Mechanism> mechanism)
    : rate_(rate), gcode_(machine), match_({.position = start}) {
  std::array<Resolution, motor_count> resolution{};
  for (std::size_t i = 0; i < resolution.size(); ++i) {
    resolution[i] = resolution_of(steps_per_mm[std::min(i, extruder)]);
  }
  grid_ = MotorGrid(std::move(mechanism), resolution, start);
  grid_.move_origin({}, start);
  state_.position = start;
  path_.at(start);
  set_grid();
}

void PointCheck::stepped(const devices::StepEdge& edge) {
  if (edge.axis >= state_.position.size()) return;
  close_state(edge.clock);
  state_.clock = edge.clock;
  state_.position[edge.axis] = edge.position;
  ++state_.steps_made[edge.axis];
}

// Edges of one clock make one state.
void PointCheck::close_state(sim::Clock now) {
  if (state_.clock < now && (states_.empty() || states_.back().clock < state_.clock)) {
    states_.push_back(state_);
    judge_states();
  }
}

void PointCheck::judge_states() {
  judge_states_until(in_flight_.empty() ? std::numeric_limits<sim::Clock>::max()
                                        : in_flight_.front().sent);
}

void PointCheck::judge_states_until(sim::Clock until) {
  while (!states_.empty() && states_.front().clock <= until) {
    const MachineState& state = states_.front();
    match_.at(state);
    path_.at(state.position);
    states_.pop_front();
  }
}

void PointCheck::command_sent(sim::Clock now, std::size_t file_line, std::string_view command) {
  close_state(now);
  in_flight_.push_back({now, file_line, std::string(command)});
}

void PointCheck::reply(sim::Clock, std::string_view line) {
  if (!in_flight_.empty() && line.contains("extrusion prevented")) {
    in_flight_.front().extrusion_prevented = true;
  }
}

void PointCheck::command_acknowledged(sim::Clock now, std::size_t, std::string_view,
                                      bool executed) {
  if (in_flight_.empty()) return;
  close_state(now);
  judge_states();
  const SentCommand command = std::move(in_flight_.front());
  in_flight_.pop_front();
  if (executed) carry_out(command);
  judge_states();
  add_missed(match_.take_missed(), judged_);
}

void PointCheck::carry_out(const SentCommand& command) {
  const Request request = gcode_.read(command.text);
  if (const Move* move = std::get_if<Move>(&request)) {
    ask(*move, command);
    return;
  }
  if (const ToolMoves* change = std::get_if<ToolMoves>(&request)) {
    for (const Move& part : change->moves) ask(part, command);
    return;
  }
  if (std::holds_alternative<NoMotion>(request) ||
      std::holds_alternative<TemperatureTarget>(request)) {
    return;
  }
  // The others wait for the end of all motion, also where the next command has been sent already.
  if (std::holds_alternative<Homing>(request)) path_.ask_homing();
  judge_states_until(std::numeric_limits<sim::Clock>::max());
  if (!std::holds_alternative<QuickStop>(request)) {
    match_.settle(!std::holds_alternative<Homing>(request));
    path_.finish();
  }
  if (const Homing* homing = std::get_if<Homing>(&request)) {
    finish_homing(*homing);
  } else if (const NewResolution* resolution = std::get_if<NewResolution>(&request)) {
    change_resolution(*resolution);
  } else if (std::holds_alternative<QuickStop>(request)) {
    match_.abandon();
    path_.forget();
    stop_here();
  }
}

void PointCheck::ask(const Move& move, const SentCommand& command) {
  match_.ask(grid_.steps_at(move.to), {command.file_line, command.text}, detour_of(move));
  if (move.over) {
    path_.ask({move.from, *move.over, {}});
    path_.ask({*move.over, move.to, {}});
  } else {
    path_.ask(move);
  }
  length_mm_ += length_of(move);
  for (std::size_t i = extruder; i < motor_count && command.extrusion_prevented; ++i) {
    gcode_.stand_at(i, move.from[i]);
  }
}

// The steps there and back again, beyond those from start to end.
Steps PointCheck::detour_of(const Move& move) const {
  if (!grid_.mechanism().is_cartesian()) return grid_.detour_of(move);
  Steps detour{};
  if (!move.arc) return detour;
  for (const std::size_t side : {0UZ, 1UZ}) {
    const std::size_t axis = side == 0 ? move.arc->first : move.arc->second;
    const auto step_at = [&](double part) {
      return std::llround(move.arc->at(part)[side] * static_cast<double>(grid_.resolution()[axis]) /
                          static_cast<double>(billionths));
    };
    std::int64_t before = step_at(0);
    detour[axis] = -std::llabs(step_at(1) - before);
    std::vector<double> parts = move.arc->turning_points();
    parts.push_back(1);
    for (const double part : parts) {
      detour[axis] += std::llabs(step_at(part) - before);
      before = step_at(part);
    }
  }
  return detour;
}

void PointCheck::finish_homing(const Homing& homing) {
  Steps meant = match_.last_target();
  if (grid_.mechanism().is_cartesian()) {
    for (std::size_t i = 0; i < homing.axes.size(); ++i) {
      if (!homing.axes[i]) continue;
      judged_.homed_elsewhere[i] =
          judged_.homed_elsewhere[i] || std::llabs(state_.position[i]) > furthest_home_steps;
      grid_.set_origin(i, 0);
      meant[i] = 0;
    }
  } else {
    meant = home_motors(homing);
  }
  match_.restart(state_, meant);
  homed_ = true;
  set_grid();
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
  const Steps before = grid_.steps_at(gcode_.position());
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (const auto value = resolution.steps_per_mm[std::min(i, extruder)]; value && *value > 0) {
      grid_.set_resolution(i, *value);
      const Steps now = grid_.steps_at(gcode_.position());
      grid_.set_origin(i, grid_.origin()[i] + before[i] - now[i]);
    }
  }
  set_grid();
}

void PointCheck::stop_here() {
  const Point here = grid_.place_of_steps(state_.position);
  for (std::size_t i = 0; i < here.size(); ++i) gcode_.stand_at(i, here[i]);
  match_.restart(state_, state_.position);
}

void PointCheck::add_missed(std::vector<UnreachedPoint> points, Judgement& judgement) const {
  for (UnreachedPoint& point : points) {
    MissedPoint missed{.file_line = point.line.file_line,
                       .text = std::move(point.line.text),
                       .seconds = rate_.seconds(point.nearest.clock)};
    const Point wanted = grid_.place_of_steps(point.target);
    const Point reached = grid_.place_of_steps(point.nearest.position);
    for (std::size_t i = 0; i < missed.axes.size(); ++i) {
      AxisArrival& axis = missed.axes[i];
      axis.wanted_steps = point.target[i] - grid_.origin()[i];
      axis.reached_steps = point.nearest.position[i] - grid_.origin()[i];
      axis.missed = axis.wanted_steps != axis.reached_steps;
      axis.wanted_mm = millimeters(wanted[i]);
      axis.reached_mm = millimeters(reached[i]);
      judgement.missed_by_axis[i] += axis.missed ? 1 : 0;
    }
    ++judgement.missed;
    if (judgement.list.size() < most_listed) judgement.list.push_back(std::move(missed));
  }
}

PointCheck::Judgement PointCheck::judgement() const {
  PointMatch match = match_;
  for (const MachineState& state : states_) match.at(state);
  match.at(state_);
  const bool nothing_requested = match.nothing_open() && in_flight_.empty();
  match.abandon();
  Judgement result = judged_;
  add_missed(match.take_missed(), result);
  result.reached = match.reached();
  result.unasked_steps = match.unasked_steps();
  for (std::size_t i = 0; i < result.moved_after_end.size(); ++i) {
    result.moved_after_end[i] = nothing_requested && state_.position[i] != match_.last_target()[i];
  }
  return result;
}

}  // namespace report
