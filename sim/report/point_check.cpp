// SPDX-License-Identifier: Apache-2.0
// From commands and edges to points and states, in the order in which they came about.
#include "sim/report/point_check.hpp"

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
                       sim::ClockRate rate, const MachineFacts& machine)
    : origin_(start), rate_(rate), gcode_(machine), match_({.position = start}) {
  for (std::size_t i = 0; i < resolution_.size(); ++i) {
    resolution_[i] = resolution_of(steps_per_mm[i]);
  }
  state_.position = start;
  path_.at(start);
  set_grid();
}

void PointCheck::set_grid() { path_.set_grid(resolution_, origin_); }

Steps PointCheck::steps_at(const Point& point) const {
  Steps steps{};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    steps[i] = origin_[i] + nearest_step(point[i], resolution_[i]);
  }
  return steps;
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
  match_.ask(steps_at(move.to), {command.file_line, command.text}, detour_of(move));
  if (move.over) {
    path_.ask({move.from, *move.over, {}});
    path_.ask({*move.over, move.to, {}});
  } else {
    path_.ask(move);
  }
  length_mm_ += length_of(move);
  if (command.extrusion_prevented) gcode_.stand_at(extruder, move.from[extruder]);
}

// The steps there and back again, beyond those from start to end.
Steps PointCheck::detour_of(const Move& move) const {
  Steps detour{};
  if (!move.arc) return detour;
  for (const std::size_t side : {0UZ, 1UZ}) {
    const std::size_t axis = side == 0 ? move.arc->first : move.arc->second;
    const auto step_at = [&](double part) {
      return std::llround(move.arc->at(part)[side] * static_cast<double>(resolution_[axis]) /
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
  for (std::size_t i = 0; i < homing.axes.size(); ++i) {
    if (homing.axes[i]) {
      judged_.homed_elsewhere[i] =
          judged_.homed_elsewhere[i] || std::llabs(state_.position[i]) > furthest_home_steps;
      origin_[i] = meant[i] = 0;
    }
  }
  match_.restart(state_, meant);
  homed_ = true;
  set_grid();
}

// The place in millimetres stays what it is.
void PointCheck::change_resolution(const NewResolution& resolution) {
  const Point& place = gcode_.position();
  for (std::size_t i = 0; i < resolution_.size(); ++i) {
    if (const auto value = resolution.steps_per_mm[i]; value && *value > 0) {
      const std::int64_t here = origin_[i] + nearest_step(place[i], resolution_[i]);
      resolution_[i] = *value;
      origin_[i] = here - nearest_step(place[i], resolution_[i]);
    }
  }
  set_grid();
}

void PointCheck::stop_here() {
  for (std::size_t i = 0; i < resolution_.size(); ++i) {
    gcode_.stand_at(i, place_of_step(state_.position[i] - origin_[i], resolution_[i]));
  }
  match_.restart(state_, state_.position);
}

void PointCheck::add_missed(std::vector<UnreachedPoint> points, Judgement& judgement) const {
  for (UnreachedPoint& point : points) {
    MissedPoint missed{.file_line = point.line.file_line,
                       .text = std::move(point.line.text),
                       .seconds = rate_.seconds(point.nearest.clock)};
    for (std::size_t i = 0; i < missed.axes.size(); ++i) {
      AxisArrival& axis = missed.axes[i];
      axis.wanted_steps = point.target[i] - origin_[i];
      axis.reached_steps = point.nearest.position[i] - origin_[i];
      axis.missed = axis.wanted_steps != axis.reached_steps;
      axis.wanted_mm = millimeters(place_of_step(axis.wanted_steps, resolution_[i]));
      axis.reached_mm = millimeters(place_of_step(axis.reached_steps, resolution_[i]));
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
