// SPDX-License-Identifier: Apache-2.0
// A chip and its printer behind the bus, at the level of registers: enough of both for the
// application's tests, with motion line by line instead of clock by clock.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <string>

#include "registers/heater_control_registers.hpp"

namespace application_test {

inline constexpr std::uint32_t clock_hz = 8'000'000;

class FakeChip {
 public:
  FakeChip();
  ~FakeChip();
  // A copy holds the state for later; the firmware's bus stays that of the first one.
  FakeChip(const FakeChip&) = default;
  FakeChip& operator=(const FakeChip&) = default;

  std::uint32_t read(std::uint32_t address);
  void write(std::uint32_t address, std::uint32_t value);
  // Time passes: motion, heat, time counter.
  void advance(std::uint32_t clocks);

  // Timer or serial line end the processor's sleep.
  bool wakes() const;
  // When the timer does.
  std::uint64_t alarm() const;

  // The serial line, from the host's side.
  std::deque<char> to_firmware;
  std::string from_firmware;
  bool gap_before_next_byte{};  // something was lost

  struct Heater {
    double celsius{25.0};
    double celsius_per_second_at_full_power{};
    double loss_per_second{};  // of the difference to 25 degrees
    double lag_seconds{};  // from the cartridge to the sensor
    double arriving_power{};  // of 1
    bool open_sensor{};
    bool tripped{};
  };
  // As the default machine describes hotend and bed: power, capacity, losses, lags.
  // The third is a second hotend, which only some machines have.
  std::array<Heater, 3> heaters{
      {{.celsius_per_second_at_full_power = 2.76, .loss_per_second = 0.0048, .lag_seconds = 2.5},
       {.celsius_per_second_at_full_power = 0.222, .loss_per_second = 0.002, .lag_seconds = 6.7},
       {.celsius_per_second_at_full_power = 2.76, .loss_per_second = 0.0048, .lag_seconds = 2.5}}};
  std::uint64_t first_reading{clock_hz / 20};  // of temperatures; there is none before

  static constexpr std::size_t axes = 5;  // X Y Z E0 E1
  // Where the axes stand, in steps from their end stops; an end stop is closed at 0 and below.
  std::array<std::int64_t, axes> mechanical{1000, 1000, 30'000, 0, 0};
  bool end_stops_above{};  // they are at the other end: closed at 0 and above
  bool end_stops_work{true};
  std::uint32_t end_stops_stuck{};  // closed, wherever the axis is; bit = axis
  // The nozzle's height above its end stop at which the probe on input 3 triggers, in mm, by the
  // nozzle's place; none without.
  static constexpr std::size_t probe_input = 3;
  std::function<double(double x, double y)> probe_mm;
  // The sensor on this input, whose level is low without filament.
  static constexpr std::size_t filament_input = 4;
  bool filament_is_out{};
  std::array<double, 3> steps_per_mm{};  // for it
  std::uint32_t clocks_per_status_read{};  // for which motion goes on: the pass of a slow processor
  // Time that a read of this register takes in addition: a task that is slow.
  std::uint32_t slow_address{}, slow_clocks{};
  std::array<std::int32_t, axes> position{};  // the hardware's counters
  std::uint32_t motors{};
  std::uint32_t fan_duty{};
  std::uint32_t heater_duty(std::size_t channel) const { return word(duty_address(channel)); }
  std::uint32_t watchdog_feeds{};  // of both keys
  std::uint32_t wrong_watchdog_feeds{};  // not the key that was due
  // Gates and supply: no trip opens it without a heater's `tripped`.
  bool supply_closed();
  bool supply_refuses{};  // to be closed
  // As `cause` has it latched, or with nothing latched.
  void open_supply(bool registers::heater_control::Supply::* cause = nullptr);
  std::uint32_t motion_watchdog_feeds{};
  std::uint32_t underruns{};
  void stop_by_watchdog();
  std::uint64_t time{};
  bool has_boot_loader{};
  unsigned boot_loader_entries{};

 private:
  struct Segment {
    std::array<std::int64_t, axes> steps{};
    std::int64_t line_ticks{};
    std::int64_t ticks{};
    double rate{};  // ticks per clock
    double acceleration{};  // ticks per clock^2
    std::uint32_t stop_mask{};
    bool continues{};
    bool ends_motion{};
  };

  static std::uint32_t duty_address(std::size_t channel);
  static std::size_t place_of(std::uint32_t address);
  std::uint32_t word(std::uint32_t address) const { return words_[place_of(address)]; }
  std::uint32_t& word(std::uint32_t address) { return words_[place_of(address)]; }
  std::uint32_t end_stops() const;
  bool end_stop_closed(std::size_t axis, std::int64_t steps) const {
    return end_stops_above ? axis < 3 && steps >= 0 : steps <= 0;
  }
  bool probe_triggers(const std::array<std::int64_t, axes>& steps) const;
  void commit();
  void command(std::uint32_t value);
  void feed(registers::heater_control::Feed::Key key);
  void switch_supply(registers::heater_control::Supply::Key key);
  void advance_motion(std::uint32_t clocks);
  void walk_to(std::int64_t line_tick);
  std::int64_t steps_until(std::size_t axis, std::int64_t line_tick) const;
  std::int64_t tick_of_stop(std::int64_t last_tick) const;
  void stop(std::uint32_t end_stops, bool software);
  void advance_heat(double seconds);
  double thermistor_ohms(std::size_t channel) const;
  static std::uint32_t count_of(double ohms);  // of the temperature converter

  static constexpr std::size_t peripherals = 9;
  static constexpr std::size_t words_of_peripheral = 128;
  std::array<std::uint32_t, peripherals * words_of_peripheral> words_{};  // without behaviour
  std::deque<Segment> queue_;
  Segment line_;  // the line under way, its flags those of its last segment
  std::int64_t line_tick_{};  // ticks of the line that are done
  double segment_time_{}, segment_time_left_{};  // clocks
  std::int64_t segment_end_tick_{};
  registers::heater_control::Supply supply_{};
  bool second_key_is_next_{};
  bool moving_{};
  bool stopped_{};
  bool stopped_by_software_{};
  bool stopped_by_watchdog_{};
  std::uint32_t stop_end_stops_{};
  std::uint32_t time_high_{};
};

}  // namespace application_test
