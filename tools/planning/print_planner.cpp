// SPDX-License-Identifier: Apache-2.0
// The passes that a line takes, and the time between them.
#include "tools/planning/print_planner.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <utility>

#include "gcode/parser.hpp"
#include "machine/machine.hpp"
#include "units/text.hpp"

namespace planning {

namespace {

// Whatever the machine has: the model of motion answers as this thermistor at 200 degrees does.
constexpr thermal::ThermistorTable hot_table{
    {.resistance_25c = units::Milliohms(100'000'000), .beta_kelvin = 4066}};
constexpr application::ConverterDescription converter{
    .capacitor_picofarads = 68'000,
    .reference_low = units::Milliohms(470'000),
    .reference_high = units::Milliohms(10'000'000),
    .supply_millivolts = 3'300,
    .threshold_millivolts = 1'650};
constexpr std::uint32_t picoseconds_per_ohm = thermal::picoseconds_per_ohm(
    converter.capacitor_picofarads, converter.supply_millivolts, converter.threshold_millivolts);

// Extrusion is never cold, and filament never ends.
application::MachineDescription heated(const application::MachineDescription& machine) {
  application::MachineDescription changed = machine;
  changed.converter = converter;
  changed.min_extrusion = machine.hotend.min;
  changed.filament_sensor = nullptr;
  return changed;
}

// As the firmware's loop: no longer between two passes while it could hand over a line.
constexpr double shortest_leap_s = 0.25e-3;
constexpr double longest_leap_s = 1e-3;
constexpr double heat_period_s = 0.1;
constexpr int most_rounds = 100;
constexpr double horizon_s = motion::Planner::horizon.count() * 1e-6;

// Heaters are at their targets at once: what waits for heat does not wait.
std::string without_wait(const gcode::Command& command, std::string_view text) {
  std::string line(text);
  if (command.letter != 'M' || (command.code != 109 && command.code != 190)) return line;
  const std::size_t code = line.find(command.code == 109 ? "109" : "190");
  line.replace(code, 3, command.code == 109 ? "104" : "140");
  if (command.has_number('R')) {
    std::ranges::replace(line, 'R', 'S');
    std::ranges::replace(line, 'r', 'S');
  }
  return line;
}

// What has no place in a plan, or nothing.
std::string_view unplanned(const gcode::Command& command) {
  if (command.letter != 'M') return {};
  if (command.code == 112) return "the emergency stop ends the print";
  if (command.code == 997) return "the boot loader ends the print";
  if (command.code == 410) return "the moment of a quick stop is not known";
  return {};
}

}  // namespace

PrintPlanner::PrintPlanner(std::uint32_t clock_hz) : PrintPlanner(machine::machine, clock_hz) {}

PrintPlanner::PrintPlanner(const application::MachineDescription& machine, std::uint32_t clock_hz)
    : clock_hz_(clock_hz),
      machine_(heated(machine)),
      model_(machine_.limits, motion::kinematics::Any(machine_.kinematics), clock_hz),
      converter_(units::Hertz(clock_hz)),
      heater_control_(units::Hertz(clock_hz)),
      motion_(machine_, units::Hertz(clock_hz), step_generator_, end_stops_,
              {.shaping = machine_.shaping ? &shaping_ : nullptr,
               .levelling = machine_.levelling != nullptr ? &levelling_ : nullptr,
               .backlash = machine_.backlash != nullptr ? &backlash_ : nullptr}),
      heat_(machine_, {hot_table, hot_table, picoseconds_per_ohm, &hot_table},
            units::Hertz(clock_hz), converter_, heater_control_),
      executor_(machine_, motion_, heat_, fan_, link_, statistics_,
                machine_.handles_filament() ? &filament_ : nullptr) {
  plan_.machine = machine_.name;
  if (machine_.levelling != nullptr) {
    model_.fit_probe(machine_.levelling->probe.input, -machine_.levelling->probe.offset[2]);
  }
  if (!motion_.start()) throw std::runtime_error("the machine's shaping does not fit this clock");
  heat_.start();
  for (int round = 0; !heat_.all_measured() || heat_.extrusion_is_cold(); ++round) {
    if (round == most_rounds) throw std::logic_error("the model's hotend is not hot");
    go_on(heat_period_s);
    if (heat_.is_due(now_.milliseconds)) heat_.update(now_);
  }
  started_ = model_.now();
}

bool PrintPlanner::take(std::size_t file_line, std::string_view text) {
  ++plan_.lines;
  std::string line(text);
  // The link refuses what is longer.
  const bool fits = text.size() <= units::longest_text;
  if (const auto command = gcode::parse(fits ? text : std::string_view())) {
    if (const auto reason = unplanned(*command); !reason.empty()) {
      refuse(file_line, text, reason);
      if (command->code == 410) return true;
      plan_.fault = reason;
      return false;
    }
    line = without_wait(*command, text);
  }
  line += '\n';
  const std::uint32_t executed = statistics_.commands_executed;
  for (std::span<const char> rest(line); !rest.empty();) {
    const std::size_t count = std::min(rest.size(), host_link::HostLink::most_bytes);
    link_.receive(rest.first(count), now_.milliseconds);
    rest = rest.subspan(count);
  }
  while (link_.waiting_lines() != 0 && !executor_.fatal()) pass();
  collect_replies();
  if (executor_.fatal()) {
    plan_.fault = "homing failed";
    refuse(file_line, text, plan_.fault);
    return false;
  }
  if (statistics_.commands_executed == executed) refuse(file_line, text, replies_);
  replies_.clear();
  model_.set_steps_per_mm(motion_.limits());
  model_.set_kinematics(motion_.kinematics());
  return true;
}

std::array<double, 3> PrintPlanner::steps_per_mm() const {
  const auto& all = model_.steps_per_mm();
  return {all[0], all[1], all[2]};
}

Plan PrintPlanner::finish() {
  while (!motion_.at_rest() && plan_.fault.empty()) {
    motion_.flush();
    pass();
  }
  const double end = std::max(model_.now(), model_.queue_end());
  plan_.seconds = (end - started_) / clock_hz_;
  plan_.moving_seconds = model_.moving_clocks() / clock_hz_;
  plan_.first_move_seconds = std::max(model_.first_step() - started_, 0.0) / clock_hz_;
  plan_.moves = model_.lines();
  plan_.underruns = model_.underruns();
  plan_.tools = machine_.tools();
  plan_.filament_of_tool_mm = model_.filament_mm();
  plan_.filament_mm = plan_.filament_of_tool_mm[0] + plan_.filament_of_tool_mm[1];
  plan_.axes = model_.axes();
  plan_.layers.assign(model_.layers().begin(), model_.layers().end());
  double layer_end = plan_.seconds;
  for (auto layer = plan_.layers.rbegin(); layer != plan_.layers.rend(); ++layer) {
    layer->begin_seconds -= started_ / clock_hz_;
    layer->seconds = layer_end - layer->begin_seconds;
    layer_end = layer->begin_seconds;
  }
  return std::move(plan_);
}

void PrintPlanner::pass() {
  const std::size_t waiting = link_.waiting_lines();
  motion_.update(now_);
  motion_.plan(now_);
  link_.update(now_.milliseconds, executor_.activity());
  executor_.update(now_);
  if (executor_.activity() == host_link::Activity::paused_for_user) executor_.prompt_answered();
  bool handed_over = false;
  while (motion_.refill(now_.microseconds)) handed_over = true;
  for (auto bytes = link_.to_send(); !bytes.empty(); bytes = link_.to_send()) {
    replies_.append(bytes.begin(), bytes.end());
    link_.sent(bytes.size());
  }
  const bool goes_on = link_.waiting_lines() != waiting || handed_over;
  if (!goes_on) leap();
}

// To the next moment at which something may be handed over.
void PrintPlanner::leap() {
  const double queued = (model_.queue_end() - model_.now()) / clock_hz_;
  if (queued <= 0) return go_on(longest_leap_s);
  if (queued > horizon_s) return go_on(queued - horizon_s + 1e-6);
  const double to_next = (model_.segment_end() - model_.now()) / clock_hz_ + 1e-6;
  go_on(model_.queue_full() ? to_next : std::clamp(to_next, 1e-6, shortest_leap_s));
}

void PrintPlanner::go_on(double seconds) {
  model_.advance(seconds * clock_hz_);
  const auto microseconds = static_cast<std::int64_t>(model_.now() / clock_hz_ * 1e6);
  now_ = {units::Milliseconds(microseconds / 1000), units::Microseconds(microseconds)};
}

// What is said besides the `ok` and the signs of life is the reason of a refusal.
void PrintPlanner::collect_replies() {
  std::string said;
  for (std::size_t begin = 0, end = 0; (end = replies_.find('\n', begin)) != std::string::npos;
       begin = end + 1) {
    const std::string_view line(replies_.data() + begin, end - begin);
    if (line.starts_with("ok") || line.starts_with("echo:busy")) continue;
    said += said.empty() ? "" : "; ";
    said += line;
  }
  replies_ = said;
}

void PrintPlanner::refuse(std::size_t file_line, std::string_view text, std::string_view reason) {
  plan_.refused.push_back(
      {.file_line = file_line, .text = std::string(text), .reason = std::string(reason)});
}

}  // namespace planning
