// SPDX-License-Identifier: Apache-2.0
// Reading of fault names.
#include "sim/machine/fault_plan.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>
#include <stdexcept>
#include <utility>

namespace machine {

namespace {

using devices::EndStopFault;
using devices::SensorFault;
using plants::BeadFault;
using plants::HeaterFault;

constexpr std::array heated_parts{std::pair{std::string_view("hotend"), Heated::hotend},
                                  std::pair{std::string_view("bed"), Heated::bed},
                                  std::pair{std::string_view("hotend1"), Heated::second_hotend}};
constexpr std::array sensor_faults{
    std::pair{std::string_view("open"), SensorFault::open},
    std::pair{std::string_view("short"), SensorFault::shorted},
    std::pair{std::string_view("stuck-high"), SensorFault::sense_stuck_high},
    std::pair{std::string_view("stuck-low"), SensorFault::sense_stuck_low}};
constexpr std::array bead_faults{std::pair{std::string_view("frozen"), BeadFault::frozen},
                                 std::pair{std::string_view("drifting"), BeadFault::drifting},
                                 std::pair{std::string_view("detached"), BeadFault::detached}};
constexpr std::array heater_faults{
    std::pair{std::string_view("heater-stuck-on"), HeaterFault::stuck_on},
    std::pair{std::string_view("heater-stuck-off"), HeaterFault::stuck_off}};
constexpr std::array end_stop_faults{
    std::pair{std::string_view("end-stop-never-closes"), EndStopFault::never_closes},
    std::pair{std::string_view("end-stop-never-opens"), EndStopFault::never_opens},
    std::pair{std::string_view("end-stop-bounces"), EndStopFault::bounces}};

// Of a capacitor's value: beyond it one may as well be lost, or another part.
constexpr double most_capacitor_factor = 10;
// Of seconds, 31 years: a fault beyond the end of time would be none.
constexpr double largest_number = 1e9;

[[noreturn]] void refuse(std::string_view text) {
  throw std::invalid_argument(
      fmt::format("no such fault: {}. Possible are:\n{}", text, fault_forms()));
}

[[noreturn]] void refuse_value(std::string_view text, std::string_view what) {
  throw std::invalid_argument(
      fmt::format("fault {}: {}. Possible are:\n{}", text, what, fault_forms()));
}

std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc{} && end == text.data() + text.size() && value >= 0 &&
                     value <= largest_number;
  return whole ? std::optional(value) : std::nullopt;
}

// What follows `prefix` and a hyphen.
std::optional<std::string_view> rest_after(std::string_view text, std::string_view prefix) {
  if (text.starts_with(prefix) && text.substr(prefix.size()).starts_with('-')) {
    return text.substr(prefix.size() + 1);
  }
  return std::nullopt;
}

bool add_heat_fault(FaultPlan& plan, Heated where, std::string_view name, double seconds) {
  if (name == "capacitor-lost") {
    plan.capacitors.push_back({seconds, where, 0});
    return true;
  }
  for (const auto& [known, fault] : sensor_faults) {
    if (name == known) {
      plan.sensors.push_back({seconds, where, fault});
      return true;
    }
  }
  for (const auto& [known, fault] : bead_faults) {
    if (name == known) {
      plan.beads.push_back({seconds, where, fault});
      return true;
    }
  }
  for (const auto& [known, fault] : heater_faults) {
    if (name == known) {
      plan.heaters.push_back({seconds, where, fault});
      return true;
    }
  }
  return false;
}

// `name=VALUE@SECONDS`.
struct TimedValue {
  std::optional<double> value, seconds;
};
std::optional<TimedValue> timed_value(std::string_view text, std::string_view name) {
  if (!text.starts_with(name) || !text.substr(name.size()).starts_with('=')) return std::nullopt;
  text.remove_prefix(name.size() + 1);
  const std::size_t at = text.find('@');
  if (at == std::string_view::npos) return TimedValue{number(text), std::nullopt};
  return TimedValue{number(text.substr(0, at)), number(text.substr(at + 1))};
}

bool add_cable_fault(FaultPlan& plan, std::string_view text) {
  const auto times = timed_value(text, "cable-pulled");
  if (!times) return false;
  if (!times->value || !times->seconds || *times->value <= 0) {
    refuse_value(text, "for how many seconds, and from when on, as in cable-pulled=3@20");
  }
  plan.cable.push_back({*times->seconds, *times->value});
  return true;
}

bool add_capacitor_fault(FaultPlan& plan, std::string_view text) {
  for (const auto& [prefix, where] : heated_parts) {
    const std::string name = std::string(prefix) + "-capacitor";
    const auto change = timed_value(text, name);
    if (!change) continue;
    if (!change->value || !change->seconds || *change->value <= 0 ||
        *change->value > most_capacitor_factor) {
      refuse_value(text, fmt::format("what part of its value it has, above 0 and up to {}, and "
                                     "from when on, as in {}=0.5@30",
                                     most_capacitor_factor, name));
    }
    plan.capacitors.push_back({*change->seconds, where, *change->value});
    return true;
  }
  return false;
}

bool add_noise(FaultPlan& plan, std::string_view text) {
  for (const auto& [name, share] :
       {std::pair{std::string_view("serial="), &plan.corrupted_bytes},
        std::pair{std::string_view("replies="), &plan.corrupted_replies}}) {
    if (!text.starts_with(name)) continue;
    const std::optional<double> value = number(text.substr(name.size()));
    if (!value || *value > 1) refuse_value(text, "a share is 0 to 1");
    *share = *value;
    return true;
  }
  return false;
}

bool add_end_stop_fault(FaultPlan& plan, std::string_view text) {
  constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    const std::optional<std::string_view> name = rest_after(text, axes[axis]);
    for (const auto& [known, fault] : end_stop_faults) {
      if (name == known) {
        plan.end_stops[axis] = fault;
        return true;
      }
    }
  }
  return false;
}

bool add_probe_fault(FaultPlan& plan, std::string_view text) {
  if (text == "probe-never-closes") {
    plan.probe = EndStopFault::never_closes;
  } else if (text == "probe-never-opens") {
    plan.probe = EndStopFault::never_opens;
  } else {
    return false;
  }
  return true;
}

}  // namespace

std::string_view fault_forms() {
  return R"(  hotend-open@SECONDS hotend-short@SECONDS hotend-stuck-high@SECONDS
  hotend-stuck-low@SECONDS hotend-frozen@SECONDS hotend-drifting@SECONDS (1 K/s down)
  hotend-detached@SECONDS
  hotend-heater-stuck-on@SECONDS hotend-heater-stuck-off@SECONDS, and the same with bed- and
  hotend1- (of a second extruder)
  hotend-capacitor-lost@SECONDS hotend-capacitor=FACTOR@SECONDS, and the same with bed-
  and hotend1-
  x-end-stop-never-closes x-end-stop-never-opens x-end-stop-bounces, and the same with y- and z-
  probe-never-closes probe-never-opens, of a machine with a probe
  serial=SHARE of the bytes to the chip that get one wrong bit, for example serial=0.001;
  replies=SHARE the same of the bytes from the chip
  cable-pulled=DURATION@SECONDS: for DURATION seconds no byte passes in either direction
)";
}

void add_fault(FaultPlan& plan, std::string_view text) {
  if (add_noise(plan, text) || add_cable_fault(plan, text) || add_capacitor_fault(plan, text) ||
      add_end_stop_fault(plan, text) || add_probe_fault(plan, text)) {
    return;
  }
  const std::size_t at = text.find('@');
  const std::optional<double> seconds =
      at == std::string_view::npos ? std::optional(0.0) : number(text.substr(at + 1));
  const std::string_view name = text.substr(0, at);
  for (const auto& [prefix, where] : heated_parts) {
    const std::optional<std::string_view> fault = rest_after(name, prefix);
    if (seconds && fault && add_heat_fault(plan, where, *fault, *seconds)) return;
  }
  refuse(text);
}

}  // namespace machine
