// SPDX-License-Identifier: Apache-2.0
// Sampling of a plant's temperature against the targets of the G-code.
#include "sim/report/temperature_record.hpp"

#include <algorithm>
#include <cmath>

namespace report {

namespace {
constexpr double sample_interval_seconds = 0.25;
constexpr double arrived_c = 1.0;
}  // namespace

TemperatureRecord::TemperatureRecord(bool bed, sim::ClockRate rate, std::size_t heater_channel,
                                     std::function<double()> celsius, const MachineFacts& machine,
                                     std::size_t tool)
    : bed_(bed),
      tool_(tool),
      rate_(rate),
      heater_channel_(heater_channel),
      celsius_(std::move(celsius)),
      gcode_(machine) {
  next_wake_ = 0;
}

void TemperatureRecord::pins_changed(sim::Clock now, sim::OutputPins pins, sim::OutputPins) {
  if (open_) open_clocks_ += now - open_since_;
  open_ = pins.heater(heater_channel_);
  open_since_ = now;
}

double TemperatureRecord::take_duty(sim::Clock now) {
  if (open_) {
    open_clocks_ += now - open_since_;
    open_since_ = now;
  }
  const sim::Clock passed = now - sampled_at_;
  const double duty =
      passed > 0 ? static_cast<double>(open_clocks_) / static_cast<double>(passed) : 0.0;
  open_clocks_ = 0;
  sampled_at_ = now;
  return duty;
}

void TemperatureRecord::wake(sim::Clock now) {
  next_wake_ = now + rate_.clocks(sample_interval_seconds);
  const double celsius = celsius_();
  const double seconds = rate_.seconds(now);
  samples_.push_back({seconds, celsius, target_c_, take_duty(now)});
  result_.max_c = std::max(result_.max_c, celsius);
  if (target_c_ > 0 && result_.seconds_to_target < 0 && celsius >= target_c_ - arrived_c) {
    result_.seconds_to_target = seconds - first_requested_seconds_;
  }
  if (held_) result_.band_c = std::max(result_.band_c, std::abs(celsius - target_c_));
}

void TemperatureRecord::command_sent(sim::Clock now, std::size_t, std::string_view command) {
  const Request request = gcode_.read(command);
  const TemperatureTarget* target = std::get_if<TemperatureTarget>(&request);
  if (target == nullptr) return;
  last_is_ours_ = target->bed == bed_ && (bed_ || target->tool == tool_);
  if (!last_is_ours_) return;
  if (target->celsius > 0 && result_.target_c <= 0) first_requested_seconds_ = rate_.seconds(now);
  held_ = held_ && target->celsius == target_c_;
  target_c_ = target->celsius;
  result_.target_c = std::max(result_.target_c, target_c_);
}

void TemperatureRecord::command_acknowledged(sim::Clock, std::size_t, std::string_view command,
                                             bool executed) {
  const bool waited = command.starts_with(bed_ ? "M190" : "M109");
  if (waited && executed && target_c_ > 0 && last_is_ours_) held_ = true;
}

TemperatureResult TemperatureRecord::result() const {
  TemperatureResult result = result_;
  result.max_c = std::max(result.max_c, celsius_());
  return result;
}

}  // namespace report
