// SPDX-License-Identifier: Apache-2.0
// From commands and edges to points and states, in the order in which they came about.
#include "sim/report/point_check.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace report {

namespace {

constexpr std::size_t most_listed = 1000;
constexpr std::size_t height = 2;
constexpr std::size_t extruder = 3;
// Of a mesh's correction in the firmware, to 5 nm of a height and 1 nm of what is left of it.
constexpr Femtometers mesh_rounding = 10 * femtometers_per_mm / 1'000'000;

}  // namespace

PointCheck::PointCheck(const std::array<double, 4>& steps_per_mm, const Steps& start,
                       sim::ClockRate rate, const MachineFacts& machine,
                       std::shared_ptr<const machine::Mechanism> mechanism)
    : rate_(rate),
      gcode_(machine),
      judges_({.position = start}, static_cast<double>(rate.hertz()), machine.fastest_mm_s) {
  std::array<Resolution, motor_count> resolution{};
  for (std::size_t i = 0; i < resolution.size(); ++i) {
    resolution[i] = resolution_of(steps_per_mm[std::min(i, extruder)]);
  }
  grid_ = MotorGrid(std::move(mechanism), resolution, start);
  grid_.move_origin({}, start);
  state_.position = start;
  for (std::size_t i = 0; i < extruder; ++i) play_.start(i, start[i]);
  if (machine.play) {
    if (const Request play = gcode_.read("M425"); std::holds_alternative<NewPlay>(play)) {
      take_up(std::get<NewPlay>(play));
    }
  }
  judges_.set_grid(grid_);
  set_shaping();
}

void PointCheck::stepped(const devices::StepEdge& edge) {
  if (edge.axis >= state_.position.size()) return;
  const std::int64_t place =
      edge.axis < extruder ? play_.follow(edge.axis, edge.position) : edge.position;
  if (place == state_.position[edge.axis]) return;
  close_state(edge.clock);
  state_.clock = edge.clock;
  state_.position[edge.axis] = place;
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
    if (shows_babystep(states_.front())) ask_babystep();
    judges_.now().at(states_.front());
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
  add_missed(judges_.now().take_missed(), judged_);
}

void PointCheck::carry_out(const SentCommand& command) {
  settle_babystep(command);
  const Femtometers babystep = gcode_.babystep();
  Request request = gcode_.read(command.text);
  if (gcode_.shaping() != judges_.shaping()) set_shaping();
  if (Move* move = std::get_if<Move>(&request)) {
    if (babystep_ && gcode_.babystep() == 0) {
      move->loose_z = babystep < 0 ? -babystep : babystep;
      babystep_.reset();
    }
    ask(*move, command);
    return;
  }
  if (const ToolMoves* change = std::get_if<ToolMoves>(&request)) {
    for (const Move& part : change->moves) ask(part, command);
    return;
  }
  if (std::holds_alternative<Babystep>(request)) {
    const std::optional<bool> rested = judges_.now().rested_at(command.sent);
    if (rested.value_or(true)) babystep_ = command;
    if (rested == true) ask_babystep();
    return;
  }
  if (std::holds_alternative<NoMotion>(request) ||
      std::holds_alternative<TemperatureTarget>(request)) {
    return;
  }
  // The others wait for the end of all motion, also where the next command has been sent already.
  const bool is_free =
      std::holds_alternative<Homing>(request) || std::holds_alternative<Probing>(request);
  if (is_free) judges_.now().end_freely();
  judge_states_until(std::numeric_limits<sim::Clock>::max());
  if (!std::holds_alternative<QuickStop>(request)) judges_.now().settle(!is_free);
  if (const Homing* homing = std::get_if<Homing>(&request)) {
    finish_homing(*homing);
  } else if (const Probing* probing = std::get_if<Probing>(&request)) {
    finish_probing(*probing, command);
  } else if (const NewResolution* resolution = std::get_if<NewResolution>(&request)) {
    change_resolution(*resolution);
  } else if (const NewPlay* play = std::get_if<NewPlay>(&request)) {
    take_up(*play);
  } else if (std::holds_alternative<QuickStop>(request)) {
    judges_.now().abandon();
    stop_here();
  }
  babystep_.reset();
}

// Before the next line it is the only motion that can come.
bool PointCheck::shows_babystep(const MachineState& state) {
  return babystep_ && state.position[height] != judges_.now().last_target()[height] &&
         !judges_.now().is_at_last_target(state.position);
}

void PointCheck::ask_babystep() {
  const SentCommand command = std::move(*babystep_);
  babystep_.reset();
  ask(gcode_.make_babystep(), command);
}

// What was to be made at once is under way by the answer to the next line, unless a shaper is late.
void PointCheck::settle_babystep(const SentCommand& next) {
  if (!babystep_) return;
  const Request request = GcodePath(gcode_).read(next.text);
  if (std::holds_alternative<Homing>(request) || std::holds_alternative<Probing>(request)) {
    babystep_.reset();
  } else if (shows_babystep(state_)) {
    ask_babystep();
  }
}

void PointCheck::ask(const Move& move, const SentCommand& command) {
  const Steps target = grid_.steps_at(above(move.mesh, move.to));
  judges_.now().ask(move, {command.file_line, command.text}, target, other_target(move));
  length_mm_ += move.length_mm();
  for (std::size_t i = extruder; i < motor_count && command.extrusion_prevented; ++i) {
    gcode_.stand_at(i, move.from[i]);
  }
}

std::optional<Steps> PointCheck::other_target(const Move& move) const {
  if (!move.mesh || !grid_.mechanism().has_own_z()) return std::nullopt;
  const Point place = above(move.mesh, move.to);
  const Steps target = grid_.steps_at(place);
  for (const Femtometers rounding : {-mesh_rounding, mesh_rounding}) {
    Point rounded = place;
    rounded[height] += rounding;
    if (const Steps other = grid_.steps_at(rounded); other != target) return other;
  }
  return std::nullopt;
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
  StepJudges judges = judges_;
  StepJudge& judge = judges.now();
  const auto see = [&](const MachineState& state) {
    if (!babystep_) judge.at(state);
  };
  std::ranges::for_each(states_, see);
  see(state_);
  const bool nothing_requested = judges.nothing_open() && in_flight_.empty() && !babystep_;
  const bool at_target = judge.is_at_last_target(state_.position);
  judge.abandon();
  Judgement result = judged_;
  add_missed(judge.take_missed(), result);
  result.reached = judges.reached();
  result.unasked_steps = judges.unasked_steps();
  for (std::size_t i = 0; i < result.moved_after_end.size(); ++i) {
    result.moved_after_end[i] =
        nothing_requested && !at_target && state_.position[i] != judge.last_target()[i];
  }
  return result;
}

}  // namespace report
