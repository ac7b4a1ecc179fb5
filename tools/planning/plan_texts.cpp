// SPDX-License-Identifier: Apache-2.0
// The words and names of a plan.
#include "tools/planning/plan_texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace planning {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, motor_count> axis_names{"x", "y", "z", "e", "e1"};
// Bytes of a refused line. The firmware takes none that is longer.
constexpr std::size_t longest_line = 256;

double rounded(double value) { return std::round(value * 1e6) / 1e6; }

Json axis_json(const AxisPlan& axis) {
  return {{"steps_forward", axis.steps_forward},
          {"steps_backward", axis.steps_backward},
          {"max_step_rate_hz", rounded(axis.max_step_rate_hz)},
          {"max_speed_mm_per_s", rounded(axis.max_speed_mm_per_s)},
          {"max_acceleration_mm_per_s2", rounded(axis.max_acceleration_mm_per_s2)}};
}

std::string duration(double seconds) {
  const auto whole = static_cast<std::int64_t>(seconds);
  return fmt::format("{}:{:02}:{:02} ({:.3f} s)", whole / 3600, whole / 60 % 60, whole % 60,
                     seconds);
}

template <typename T>
std::span<const T> first_of(const std::vector<T>& all, std::size_t most) {
  return std::span(all).first(std::min(most, all.size()));
}

// How many of them are not listed; nothing where all are.
std::string more(std::size_t all, std::size_t most, std::string_view what) {
  return all > most ? fmt::format("{} more {}\n", all - most, what) : std::string();
}

std::size_t motors_of(const Plan& plan) { return axis_count + plan.tools - 1; }

std::string shown(const RefusedLine& line) { return line.text.substr(0, longest_line); }

}  // namespace

std::string to_text(const Plan& plan, const ListLimits& limits) {
  std::string text = fmt::format("{}: {} lines, {} moves\n", plan.machine, plan.lines, plan.moves);
  text += fmt::format("time      {} without heating, {:.3f} s in motion\n", duration(plan.seconds),
                      plan.moving_seconds);
  text += fmt::format("filament  {:.1f} mm", plan.filament_mm);
  if (plan.tools > 1) {
    text += fmt::format(": {:.1f} of T0, {:.1f} of T1", plan.filament_of_tool_mm[0],
                        plan.filament_of_tool_mm[1]);
  }
  text += '\n';
  for (std::size_t i = 0; i < motors_of(plan); ++i) {
    const AxisPlan& axis = plan.axes[i];
    text += fmt::format(
        "{}  {} steps forward, {} backward; at most {:.2f} mm/s, {:.1f} mm/s², "
        "{:.0f} steps/s\n",
        axis_names[i], axis.steps_forward, axis.steps_backward, axis.max_speed_mm_per_s,
        axis.max_acceleration_mm_per_s2, axis.max_step_rate_hz);
  }
  for (const Layer& layer : first_of(plan.layers, limits.layers)) {
    text += fmt::format("layer at Z {:.3f} mm  {:.3f} s\n", layer.z_mm, layer.seconds);
  }
  text += more(plan.layers.size(), limits.layers, "layers");
  if (plan.underruns != 0) text += fmt::format("{} underruns\n", plan.underruns);
  for (const RefusedLine& line : first_of(plan.refused, limits.refused)) {
    text += fmt::format("line {} refused: {}  ({})\n", line.file_line, shown(line), line.reason);
  }
  text += more(plan.refused.size(), limits.refused, "lines refused");
  if (!plan.fault.empty()) text += fmt::format("ends early: {}\n", plan.fault);
  return text;
}

std::string to_json(const Plan& plan, const ListLimits& limits) {
  Json json{{"machine", plan.machine},
            {"seconds", rounded(plan.seconds)},
            {"moving_seconds", rounded(plan.moving_seconds)},
            {"first_move_seconds", rounded(plan.first_move_seconds)},
            {"lines", plan.lines},
            {"moves", plan.moves},
            {"underruns", plan.underruns},
            {"filament_mm", rounded(plan.filament_mm)},
            {"fault", plan.fault},
            {"axes", Json::object()},
            {"layer_count", plan.layers.size()},
            {"layers", Json::array()},
            {"refused_lines", plan.refused.size()},
            {"refused", Json::array()}};
  if (plan.tools > 1) {
    json["filament_of_tool_mm"] = {rounded(plan.filament_of_tool_mm[0]),
                                   rounded(plan.filament_of_tool_mm[1])};
  }
  for (std::size_t i = 0; i < motors_of(plan); ++i) {
    json["axes"][std::string(axis_names[i])] = axis_json(plan.axes[i]);
  }
  for (const Layer& layer : first_of(plan.layers, limits.layers)) {
    json["layers"].push_back({{"z_mm", rounded(layer.z_mm)},
                              {"begin_seconds", rounded(layer.begin_seconds)},
                              {"seconds", rounded(layer.seconds)}});
  }
  for (const RefusedLine& line : first_of(plan.refused, limits.refused)) {
    json["refused"].push_back(
        {{"line", line.file_line}, {"text", shown(line)}, {"reason", line.reason}});
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace planning
