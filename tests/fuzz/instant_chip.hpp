// SPDX-License-Identifier: Apache-2.0
// A chip behind the bus on which nothing takes time: a line is made as soon as its first segment is
// committed, heaters stay as warm as they are, and the time is what the test says. For programs
// that must execute tens of thousands of inputs a second.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace fuzz {

// Plain bytes, so that a state is kept and brought back by a copy.
struct InstantChip {
  static constexpr std::uint32_t clock_hz = 8'000'000;
  static constexpr std::size_t axes = 5;  // X Y Z E0 E1
  static constexpr std::size_t channels = 2;  // hotend and bed

  std::uint32_t read(std::uint32_t address);
  void write(std::uint32_t address, std::uint32_t value);
  std::uint32_t heater_duty(std::size_t channel) const;
  void set_temperature(std::size_t channel, double celsius);

  std::uint64_t time{};
  std::uint64_t busy_until{};  // when the lines made would end
  // Where the axes stand, in steps from their end stops; these are closed at 0 and below.
  std::array<std::int64_t, axes> mechanical{1000, 1000, 30'000, 0, 0};
  std::array<std::int32_t, axes> position{};  // the hardware's counters
  std::uint32_t lines_made{};
  std::uint32_t motors{};
  bool supply_closed{};

  // The lowest and the highest place since forget_extremes().
  std::array<std::int64_t, axes> lowest{}, highest{};
  void forget_extremes() { lowest = highest = mechanical; }
  // A stop waits for its acknowledgement.
  bool stopped() const { return stopped_; }

 private:
  static constexpr std::size_t peripherals = 9;
  static constexpr std::size_t words_of_peripheral = 128;

  static std::size_t place_of(std::uint32_t address);
  std::uint32_t word(std::uint32_t address) const { return words_[place_of(address)]; }
  std::uint32_t end_stops() const;
  void commit();
  std::uint64_t segment_clocks() const;
  void make_line(std::uint32_t backward, std::uint32_t stop_mask);
  void command(std::uint32_t value);
  std::uint32_t stop_cause() const;

  std::array<std::uint32_t, peripherals * words_of_peripheral> words_{};  // without behaviour
  std::array<std::uint32_t, channels> sensor_counts_{};
  std::uint32_t stop_end_stops_{};
  bool stopped_{};
  bool stopped_by_software_{};
  std::uint32_t time_high_{};
};

// The serial line, not part of a state.
struct SerialLine {
  std::string_view to_firmware;
  std::string from_firmware;
};

// What the firmware's bus leads to.
InstantChip& instant_chip();
SerialLine& serial_line();

}  // namespace fuzz
