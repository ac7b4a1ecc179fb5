// SPDX-License-Identifier: Apache-2.0
// The names of report.json.
#include "sim/report/json_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "sim/report/verdict.hpp"

namespace report {

namespace {

using Json = nlohmann::ordered_json;

// Six digits after the point say everything here and keep files of two runs comparable.
double rounded(double value) { return std::round(value * 1e6) / 1e6; }

Json axis_json(const AxisResult& axis) {
  return {{"steps_forward", axis.steps_forward},
          {"steps_backward", axis.steps_backward},
          {"final_position_steps", axis.final_position_steps},
          {"final_position_mm", rounded(axis.final_position_mm)},
          {"max_step_rate_hz", rounded(axis.max_step_rate_hz)},
          {"illegal_pulses", axis.illegal_pulses},
          {"disabled_pulses", axis.disabled_pulses},
          {"slipped_steps", axis.slipped_steps},
          {"frame_steps", axis.frame_steps},
          {"unasked_steps", axis.unasked_steps},
          {"peak_load", rounded(axis.peak_load)}};
}

Json temperature_json(const TemperatureResult& temperature) {
  Json json{{"target_c", rounded(temperature.target_c)},
            {"max_c", rounded(temperature.max_c)},
            {"seconds_to_target", nullptr},
            {"band_c", rounded(temperature.band_c)}};
  if (temperature.seconds_to_target >= 0) {
    json["seconds_to_target"] = rounded(temperature.seconds_to_target);
  }
  return json;
}

Json messages_json(const Results& results) {
  Json messages = Json::array();
  for (const Message& message : results.messages) {
    messages.push_back({{"seconds", rounded(message.seconds)},
                        {"file_line", message.file_line},
                        {"error", message.error},
                        {"text", message.text}});
  }
  return messages;
}

Json tasks_json(const Results& results) {
  Json tasks = Json::array();
  for (const TaskResult& task : results.tasks) {
    tasks.push_back({{"name", task.name},
                     {"longest_clocks", task.longest_clocks},
                     {"overruns", task.overruns}});
  }
  return tasks;
}

Json counts_json(const std::array<std::uint64_t, motor_count>& counts, std::size_t motors) {
  Json json;
  for (std::size_t i = 0; i < motors; ++i) json[axis_names[i]] = counts[i];
  return json;
}

Json refused_json(const std::vector<RefusedLine>& lines) {
  Json json = Json::array();
  for (const RefusedLine& line : lines) {
    json.push_back({{"file_line", line.file_line}, {"text", line.text}, {"reason", line.reason}});
  }
  return json;
}

Json missed_json(const std::vector<MissedPoint>& points) {
  Json json = Json::array();
  for (const MissedPoint& point : points) {
    Json axes = Json::object();
    for (std::size_t i = 0; i < point.axes.size(); ++i) {
      const AxisArrival& axis = point.axes[i];
      if (axis.missed) {
        axes[axis_names[i]] = {{"wanted_mm", rounded(axis.wanted_mm)},
                               {"reached_mm", rounded(axis.reached_mm)},
                               {"wanted_steps", axis.wanted_steps},
                               {"reached_steps", axis.reached_steps}};
      }
    }
    json.push_back({{"file_line", point.file_line},
                    {"text", point.text},
                    {"seconds", rounded(point.seconds)},
                    {"axes", axes}});
  }
  return json;
}

}  // namespace

std::string to_json(const Results& results) {
  Json json;
  json["result"] = name_of(results.outcome);
  json["fault"] = results.fault;
  json["verdict"] = verdict_of(results);
  json["problems"] = results.findings.problems;
  json["file"] = results.file;
  json["machine"] = results.machine;
  json["clock_hz"] = results.clock_hz;
  json["cycles"] = results.cycles;
  json["simulated_seconds"] = rounded(results.simulated_seconds);
  json["moving_seconds"] = rounded(results.moving_seconds);
  json["wall_seconds"] = rounded(results.wall_seconds);
  json["lines_sent"] = results.lines_sent;
  json["resends"] = results.resends;
  json["commands_executed"] = results.commands_executed;
  json["commands_refused"] = results.commands_refused;
  json["busy_replies"] = results.busy_replies;
  for (std::size_t i = 0; i < results.motors; ++i) {
    json["axes"][axis_names[i]] = axis_json(results.axes[i]);
  }
  json["path"] = {
      {"max_deviation_mm", rounded(results.max_deviation_mm)},
      {"length_mm", rounded(results.length_mm)},
      {"points_reached", results.points_reached},
      {"points_missed", results.points_missed},
      {"points_shaped", results.points_shaped},
      {"max_shaping_mm", rounded(results.max_shaping_mm)},
      {"points_missed_by_axis", counts_json(results.findings.missed_by_axis, results.motors)}};
  json["lines"] = {{"refused", results.findings.refused_count},
                   {"warnings", results.findings.warning_count},
                   {"lost", results.findings.lines_lost}};
  json["refused_lines"] = refused_json(results.findings.refused);
  json["warnings"] = refused_json(results.findings.warnings);
  json["missed_points"] = missed_json(results.findings.missed);
  json["queue"] = {{"underruns", results.underruns},
                   {"late_ticks", results.late_ticks},
                   {"guard_stalls_cycles", results.guard_stalls_cycles},
                   {"max_depth", results.max_queue_depth}};
  json["hotend"] = temperature_json(results.hotend);
  json["bed"] = temperature_json(results.bed);
  if (results.motors == motor_count) json["hotend_1"] = temperature_json(results.second_hotend);
  json["firmware"] = {{"text_bytes", results.firmware.text_bytes},
                      {"data_bytes", results.firmware.data_bytes},
                      {"bss_bytes", results.firmware.bss_bytes},
                      {"stack_peak_bytes", results.firmware.stack_peak_bytes}};
  json["processor"] = {{"busy_percent", rounded(results.processor_busy_percent)},
                       {"saturated_seconds", rounded(results.processor_saturated_seconds)},
                       {"instructions", results.instructions},
                       {"longest_pass_clocks", results.longest_pass_clocks},
                       {"tasks", tasks_json(results)}};
  json["serial"] = {{"bytes_corrupted", results.serial_bytes_corrupted}};
  json["messages"] = messages_json(results);
  json["messages_dropped"] = results.messages_dropped;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace report
