// SPDX-License-Identifier: Apache-2.0
// Faults of the simulated printer, as a user names them on the command line.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sim/devices/end_stop.hpp"
#include "sim/devices/thermistor_input.hpp"
#include "sim/plants/heated_block.hpp"

namespace machine {

enum class Heated : std::uint8_t { hotend, bed, second_hotend };

struct TimedSensorFault {
  double seconds{};
  Heated where{};
  devices::SensorFault fault{};
};
struct TimedBeadFault {
  double seconds{};
  Heated where{};
  plants::BeadFault fault{};
};
struct TimedHeaterFault {
  double seconds{};
  Heated where{};
  plants::HeaterFault fault{};
};

struct TimedCapacitorFault {
  double seconds{};
  Heated where{};
  double factor{};  // of its value; 0: it is lost
};
struct PulledCable {
  double from_seconds{};
  double for_seconds{};
};

struct FaultPlan {
  std::vector<TimedSensorFault> sensors;
  std::vector<TimedBeadFault> beads;
  std::vector<TimedHeaterFault> heaters;
  std::vector<TimedCapacitorFault> capacitors;
  std::vector<PulledCable> cable;
  std::array<devices::EndStopFault, 3> end_stops{};  // x y z
  devices::EndStopFault probe{};  // never closes, never opens
  double corrupted_bytes = 0;  // share of the bytes to the chip
  double corrupted_replies = 0;  // share of the bytes from the chip
};

// The forms, one line each, for help texts.
std::string_view fault_forms();

// Adds the fault that `text` names: `hotend-open@30`, `bed-heater-stuck-on@0`, `hotend-frozen@60`,
// `hotend-capacitor=0.5@30`, `x-end-stop-bounces`, `serial=0.001`, `cable-pulled=3@20`. Throws
// std::invalid_argument with what is wrong and the possible forms.
void add_fault(FaultPlan& plan, std::string_view text);

}  // namespace machine
