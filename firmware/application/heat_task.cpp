// SPDX-License-Identifier: Apache-2.0
// Sensor to loop to gate, ten times a second: the hotend, and a part of a period later the bed, and
// a second hotend, so that no pass of the main loop does two of them.
#include "application/heat_task.hpp"

#include <algorithm>
#include <limits>
#include <type_traits>

#include "application/task_timing.hpp"
#include "units/loop_bound.hpp"

namespace application {
namespace {

constexpr std::uint32_t charges = 16;
// Time constants of the low reference after which the capacitor is discharged to 2^-16.
constexpr std::int64_t discharge_time_constants = 11;
// A charge may take so much longer than at the lowest temperature before it counts as
// an open sensor.
constexpr std::int64_t charge_margin = 2;
constexpr units::Microseconds pause{1'000};
constexpr units::Microseconds gate_slot{2'000};
constexpr units::Milliseconds sensor_timeout{1'000};
// The hardware cuts off beyond the software's own limits, so that the fault has its
// proper name first.
constexpr units::Millicelsius cut_off_margin{10'000};
// Hot enough that no neighbour makes it so is a part below so many times the count of its cut-off:
// above 150 degrees with the hotend's limit, above 60 with the bed's.
constexpr std::uint32_t hot_factor = 8;
// After the heat that was still on its way to the sensor; a bed is slow.
constexpr units::Milliseconds hotend_settle{15'000};
constexpr units::Milliseconds bed_settle{60'000};
// Heat is requested and the supply does not close: what vetoes it at its start is not latched.
constexpr units::Milliseconds supply_patience{2'000};

// A bed is slow: Marlin's WATCH_BED_TEMP_PERIOD and THERMAL_PROTECTION_BED_HYSTERESIS.
constexpr thermal::ProtectionSettings bed_protection{.watch_period = units::Milliseconds{60'000}};

thermal::HeaterSettings settings_of(const HeaterDescription& heater) {
  thermal::HeaterSettings settings;
  settings.minimum = heater.min;
  settings.maximum = heater.max;
  settings.gains = heater.gains;
  settings.model = &heater.model;
  return settings;
}

thermal::HeaterSettings bed_settings_of(const HeaterDescription& heater) {
  thermal::HeaterSettings settings = settings_of(heater);
  settings.protection = bed_protection;
  return settings;
}

// The message to the host: the rarest cause first, as it may cause the others.
std::string_view describe_opening(const drivers::SupplyStatus& supply) {
  if (supply.veto_opened) return "Error:Heater supply cut off: board's veto (clock watch)";
  if (supply.emergency_stop_opened) return "Error:Heater supply cut off: emergency stop";
  if (supply.watchdog_opened) return "Error:Heater supply cut off: watchdog not fed";
  if (supply.trip_opened) return "Error:Heater supply cut off: trip";
  return "Error:Heater supply cut off";
}

thermal::ReferenceResistors references_of(const ConverterDescription& converter) {
  return {.low = converter.reference_low, .high = converter.reference_high};
}

}  // namespace

// A template, so that an image for one extruder need not know it. On a host one that is not there
// is never looked at.
template <class Machine>
HeatTask::SecondHotend HeatTask::second_hotend(const Machine& machine,
                                               const ThermalTables& tables) {
  if constexpr (units::most_tools == 1) {
    // Dependent on the argument: compilers look at what is not, used or not.
    using Nothing = std::conditional_t<sizeof(Machine) != 0, SecondHotend, void>;
    return Nothing{};
  } else {
    const bool present = machine.second_tool.has_value();
    const HeaterDescription& heater = present ? machine.second_tool->hotend : machine.hotend;
    const thermal::ThermistorTable& table = present ? *tables.second_hotend : tables.hotend;
    return {{{heater,
              table,
              {table, references_of(machine.converter)},
              thermal::HeaterLoop(settings_of(heater))}}};
  }
}

HeatTask::HeatTask(const MachineDescription& machine, const ThermalTables& tables,
                   units::Hertz clock, drivers::TemperatureConverter& converter,
                   drivers::HeaterControl& control)
    : machine_(machine),
      circuit_{.picoseconds_per_ohm = tables.picoseconds_per_ohm,
               .clock = clock,
               .charges = charges,
               .delay_cycles = drivers::TemperatureConverter::delay_cycles},
      converter_(converter),
      control_(control),
      parts_{{{machine.hotend,
               tables.hotend,
               {tables.hotend, references_of(machine.converter)},
               thermal::HeaterLoop(settings_of(machine.hotend))},
              {machine.bed,
               tables.bed,
               {tables.bed, references_of(machine.converter)},
               thermal::HeaterLoop(bed_settings_of(machine.bed))}}},
      second_hotend_(second_hotend(machine, tables)),
      least_extrusion_(machine.min_extrusion) {}

void HeatTask::start() {
  constexpr std::int64_t picoseconds_per_microsecond = 1'000'000;
  constexpr std::int64_t milliohms_per_ohm = 1'000;
  const ConverterDescription& circuit = machine_.converter;
  std::int64_t coldest_milliohms = 0;
  std::uint32_t short_limit = std::numeric_limits<std::uint32_t>::max();
  units::LoopBound<most_parts> heaters;
  for (std::size_t i = 0; i < parts(); ++i) {
    heaters.next();
    const Part& part = this->part(i);
    coldest_milliohms =
        std::max(coldest_milliohms, part.table.resistance(part.description.min).count());
    short_limit = std::min(short_limit, thermal::Sensor::short_limit(part.table, circuit_));
  }
  const std::int64_t discharge = discharge_time_constants * circuit.reference_low.count() /
                                 milliohms_per_ohm * circuit.capacitor_picofarads /
                                 picoseconds_per_microsecond;
  const std::int64_t longest_charge = charge_margin * (coldest_milliohms / milliohms_per_ohm) *
                                      circuit_.picoseconds_per_ohm / picoseconds_per_microsecond;
  converter_.start({.charges = charges,
                    .discharge = units::Microseconds(discharge),
                    .longest_charge = units::Microseconds(longest_charge),
                    .pause = pause,
                    .short_limit = short_limit});
  control_.set_slot(gate_slot);
  control_.set_timeouts(task_timing::heater_watchdog, sensor_timeout);
}

bool HeatTask::is_due(units::Milliseconds now) const {
  constexpr units::Milliseconds period = thermal::HeaterLoop::period;
  const auto turn = static_cast<std::int64_t>(next_);
  const units::Milliseconds due =
      next_ == 0 ? period : period * turn / static_cast<std::int64_t>(parts());
  if (round_began_ && now - *round_began_ < due) return false;
  // The watchdog is fed with the last turn.
  return next_ + 1 < parts() || now - fed_ >= task_timing::least_heat_period;
}

void HeatTask::update(const Now& now) {
  if (next_ == 0) {
    round_began_ = now.milliseconds;
    watch_supply(now.milliseconds);
  }
  update(part(next_++), now);
  if (next_ < parts()) return;
  next_ = 0;
  fed_ = now.milliseconds;
  control_.feed(drivers::FeedKey::first);
  second_key_is_due_ = true;
}

void HeatTask::complete_feed() {
  if (!second_key_is_due_) return;
  second_key_is_due_ = false;
  control_.feed(drivers::FeedKey::second);
}

// Closed once, when some heater has its limits and nothing is requested; what opens it then
// is a fault.
void HeatTask::watch_supply(units::Milliseconds now) {
  const drivers::SupplyStatus supply = control_.supply();
  if (supply_closed_ && !supply.closed && hardware_fault_.empty()) {
    hardware_fault_ = describe_opening(supply);
  }
  supply_closed_ = supply_closed_ || supply.closed;
  if (supply_closed_ || !hardware_fault_.empty()) return;
  bool some_locked = false;
  units::LoopBound<most_parts> heaters;
  for (std::size_t i = 0; i < parts(); ++i) {
    heaters.next();
    some_locked = some_locked || part(i).limits_locked;
    control_.clear_trips(part(i).description.heater_channel);
  }
  if (some_locked) control_.close_supply();
  if (!some_locked || !wanted()) {
    supply_missing_since_ = now;
  } else if (now - supply_missing_since_ > supply_patience) {
    hardware_fault_ = "Error:Heater supply does not close";
  }
}

// A reading that is ok shows capacitor and threshold, and so determines the limits in counts.
void HeatTask::lock_limits(Part& part, const thermal::SensorReading& reading) {
  const HeaterDescription& heater = part.description;
  const auto limits =
      part.sensor.limits(heater.min - cut_off_margin, heater.max + cut_off_margin, reading);
  if (!limits) return;
  const bool is_bed = &part == &this->part(Heater::bed);
  part.limits_locked =
      control_.lock_limits(heater.heater_channel, {.counts = *limits,
                                                   .hot = hot_factor * limits->minimum,
                                                   .settle = is_bed ? bed_settle : hotend_settle});
  if (!part.limits_locked) hardware_fault_ = "Error:Heater limits refused";
}

void HeatTask::update(Part& part, const Now& now) {
  const std::size_t gate = part.description.heater_channel;
  const thermal::SensorReading reading = converter_.reading(part.description.sensor_channel);
  if (!part.limits_locked && hardware_fault_.empty() && reading.state == thermal::SensorState::ok) {
    lock_limits(part, reading);
  }
  const bool was_heating = part.loop.duty() != 0;
  const bool tripped = control_.status(gate).tripped;
  if (tripped && was_heating) part.loop.report_cut_off();
  const thermal::Duty duty = part.loop.update(part.sensor.temperature(reading), now.milliseconds);
  if (const auto temperature = part.loop.temperature()) part.temperature = *temperature;
  // Trips while nothing was requested (for example before the first conversion) are cleared at the
  // first request for heat; a cause that persists trips again at once.
  if (tripped && !was_heating && duty != 0) control_.clear_trips(gate);
  control_.set_duty(gate, part.limits_locked && supply_closed_ ? duty : thermal::Duty{0});
}

void HeatTask::shut_down() {
  control_.open_supply();
  second_key_is_due_ = false;
  switch_all_off();
  units::LoopBound<most_parts> heaters;
  for (std::size_t i = 0; i < parts(); ++i) {
    heaters.next();
    control_.set_duty(part(i).description.heater_channel, 0);
  }
}

void HeatTask::switch_all_off() {
  units::LoopBound<most_parts> heaters;
  for (std::size_t i = 0; i < parts(); ++i) {
    heaters.next();
    part(i).loop.set_target(thermal::HeaterLoop::off);
  }
}

void HeatTask::set_cooling(const thermal::Cooling& cooling) {
  units::LoopBound<most_parts> heaters;
  for (std::size_t i = 0; i < parts(); ++i) {
    heaters.next();
    const bool extrudes = i == static_cast<std::size_t>(hotend());
    part(i).loop.set_cooling(extrudes ? cooling : thermal::Cooling{.fan = cooling.fan});
  }
}

void HeatTask::set_target(Heater heater, units::Millicelsius target) {
  loop(heater).set_target(target);
}

bool HeatTask::wanted() const {
  units::LoopBound<most_parts> heaters;
  for (std::size_t i = 0; i < parts(); ++i) {
    heaters.next();
    if (part(i).loop.target() != thermal::HeaterLoop::off) return true;
  }
  return false;
}

bool HeatTask::all_measured() const {
  units::LoopBound<most_parts> heaters;
  for (std::size_t i = 0; i < parts(); ++i) {
    heaters.next();
    if (!part(i).loop.temperature()) return false;
  }
  return true;
}

bool HeatTask::extrusion_is_cold(std::size_t tool) const {
  if (cold_extrusion_allowed_) return false;
  const auto temperature = loop(hotend_of(tool)).temperature();
  return !temperature || *temperature < least_extrusion_;
}

}  // namespace application
