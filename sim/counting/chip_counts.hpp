// SPDX-License-Identifier: Apache-2.0
// The counters of the Verilated chip: the only file that knows the names of these registers.
#pragma once

#include "sim/counting/counts.hpp"

namespace counting {

// Registers have the names of their signals, see tools/hardware/name_registers.awk.
#define REGISTER(path, name) root.printer_core__DOT__##path##__DOT__##name##_q
#define MOTION(path, name) REGISTER(motion__DOT__generator##path, name)
#define SENSORS(path, name) REGISTER(thermal__DOT__sensors##path, name)
#define BASE(name) MOTION(__DOT__core__DOT__base, name)
#define PACE(name) MOTION(__DOT__core__DOT__pace, name)
#define WATCH(name) MOTION(__DOT__core__DOT__watch, name)
#define HEATER_TIME(name) REGISTER(thermal__DOT__heat__DOT__timing, name)
#define FAN(name) REGISTER(thermal__DOT__cooling_fan__DOT__modulator, name)
#define FAN_SETTING(name) REGISTER(thermal__DOT__cooling_fan__DOT__registers, name)
#define PROCESSOR(path, name)                                                                     \
  REGISTER(                                                                                       \
      with_processor_computing__DOT__cpu__DOT__machine_mode__DOT__control_status_registers##path, \
      name)

// `Root` is the structure of all the model's variables. A template, so that a model without these
// names can be used without leaps.
template <class Root>
inline constexpr bool has_counts = requires(Root& root) {
  REGISTER(machine_timer, now_cycles);
  HEATER_TIME(slot_phase);
  BASE(phase);
};

// mcycle is among them where the model has the processor.
template <class Root>
inline constexpr bool has_processor =
    requires(Root& root) { PROCESSOR(__DOT__cycle_counter, counted); };

// The converter of a chip with three heaters has a third channel.
template <class Root>
inline constexpr bool has_third_channel =
    requires(Root& root) { SENSORS(__DOT__each_channel_n3_present_timer, wake_cycles); };

// With two channels the second once more.
template <class Root>
std::uint32_t last_converter_wake(const Root& root) {
  if constexpr (has_third_channel<Root>) {
    return SENSORS(__DOT__each_channel_n3_present_timer, wake_cycles);
  } else {
    return SENSORS(__DOT__each_channel_n2_present_timer, wake_cycles);
  }
}

// Where time must not be carried over although all blocks are at rest.
template <class Root>
bool counts_are_usual(const Root& root) {
  // In a leap the time base does several of its clocks in one.
  return PACE(leap) == 0;
}

template <class Root>
Counts read_counts(const Root& root) {
  constexpr std::uint32_t last_of_tick = 1023;  // thermal_pkg.tick_cycles - 1
  std::uint64_t processor_cycles = 0;
  bool processor_cycles_stopped = true;
  if constexpr (has_processor<Root>) {
    processor_cycles = PROCESSOR(__DOT__cycle_counter, counted);
    processor_cycles_stopped = PROCESSOR(, cycle_stopped) != 0;
  }
  return {.timer = {.now = REGISTER(machine_timer, now_cycles),
                    .deadline = REGISTER(machine_timer, deadline_cycles),
                    .reached = REGISTER(machine_timer, reached) != 0},
          .motion_time = MOTION(__DOT__core, now),
          .processor_cycles = processor_cycles,
          .processor_cycles_stopped = processor_cycles_stopped,
          .converter_tick = {.phase = SENSORS(, tick_phase), .last = last_of_tick},
          .heater_tick = {.phase = HEATER_TIME(tick_phase), .last = last_of_tick},
          .heater_slot = {.phase = HEATER_TIME(slot_phase), .last = HEATER_TIME(last_phase)},
          .converter_cycles = {SENSORS(, now_cycles)},
          .converter_wakes = {SENSORS(__DOT__each_channel_n1_present_timer, wake_cycles),
                              SENSORS(__DOT__each_channel_n2_present_timer, wake_cycles),
                              last_converter_wake(root)},
          .motion_watchdog = {.limit = MOTION(__DOT__registers, watchdog_stored),
                              .moving = BASE(active) != 0,
                              .left = WATCH(left),
                              .expired = WATCH(expired) != 0},
          .time_base = {.active = BASE(active) != 0,
                        .advance = PACE(advance) != 0,
                        .phase = BASE(phase),
                        .rate = BASE(rate),
                        .acceleration = static_cast<std::int64_t>(BASE(acceleration)),
                        .jerk = static_cast<std::int64_t>(BASE(jerk)),
                        .rate_floor = MOTION(__DOT__settings, rate_floor),
                        .accelerating = BASE(accelerating) != 0,
                        .decelerating = BASE(decelerating) != 0},
          .fan = {.slot_cycles = FAN_SETTING(period_stored),
                  .duty = FAN_SETTING(duty_stored),
                  .remaining_cycles = REGISTER(thermal__DOT__cooling_fan, remaining_cycles),
                  .slot = FAN(slot),
                  .slots_on = FAN(slots_on),
                  .level = FAN(level) != 0}};
}

// All of them, also those that only software changes. Logic that depends on them is stale until the
// model is settled.
template <class Root>
void write_counts(const Counts& counts, Root& root) {
  REGISTER(machine_timer, now_cycles) = counts.timer.now;
  REGISTER(machine_timer, deadline_cycles) = counts.timer.deadline;
  REGISTER(machine_timer, reached) = counts.timer.reached;
  MOTION(__DOT__core, now) = counts.motion_time;
  if constexpr (has_processor<Root>) {
    PROCESSOR(__DOT__cycle_counter, counted) = counts.processor_cycles;
    PROCESSOR(, cycle_stopped) = counts.processor_cycles_stopped;
  }
  SENSORS(, tick_phase) = static_cast<std::uint16_t>(counts.converter_tick.phase);
  HEATER_TIME(tick_phase) = static_cast<std::uint16_t>(counts.heater_tick.phase);
  HEATER_TIME(slot_phase) = counts.heater_slot.phase;
  HEATER_TIME(last_phase) = counts.heater_slot.last;
  SENSORS(, now_cycles) = counts.converter_cycles.now;
  SENSORS(__DOT__each_channel_n1_present_timer, wake_cycles) = counts.converter_wakes[0];
  SENSORS(__DOT__each_channel_n2_present_timer, wake_cycles) = counts.converter_wakes[1];
  if constexpr (has_third_channel<Root>) {
    SENSORS(__DOT__each_channel_n3_present_timer, wake_cycles) = counts.converter_wakes[2];
  }
  MOTION(__DOT__registers, watchdog_stored) = counts.motion_watchdog.limit;
  WATCH(left) = counts.motion_watchdog.left;
  WATCH(expired) = counts.motion_watchdog.expired;
  BASE(active) = counts.time_base.active;
  PACE(advance) = counts.time_base.advance;
  BASE(phase) = counts.time_base.phase;
  BASE(rate) = counts.time_base.rate;
  BASE(acceleration) = static_cast<std::uint64_t>(counts.time_base.acceleration);
  BASE(jerk) = static_cast<std::uint64_t>(counts.time_base.jerk);
  MOTION(__DOT__settings, rate_floor) = counts.time_base.rate_floor;
  BASE(accelerating) = counts.time_base.accelerating;
  BASE(decelerating) = counts.time_base.decelerating;
  FAN_SETTING(period_stored) = counts.fan.slot_cycles;
  FAN_SETTING(duty_stored) = static_cast<std::uint8_t>(counts.fan.duty);
  REGISTER(thermal__DOT__cooling_fan, remaining_cycles) = counts.fan.remaining_cycles;
  FAN(slot) = counts.fan.slot;
  FAN(slots_on) = counts.fan.slots_on;
  FAN(level) = counts.fan.level;
}

#undef PROCESSOR
#undef FAN_SETTING
#undef FAN
#undef WATCH
#undef PACE
#undef BASE
#undef HEATER_TIME
#undef SENSORS
#undef MOTION
#undef REGISTER

}  // namespace counting
