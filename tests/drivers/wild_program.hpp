// SPDX-License-Identifier: Apache-2.0
// A program that writes anything to a step generator at any moment, with switches, emergencies and
// a start input besides; and what the registers' description and the pins say of it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <random>

#include <verilated.h>
#include <Vstep_generator.h>

#include "registers/step_generator_registers.hpp"
#include "tests/drivers/motor_pin_watch.hpp"

namespace tests {

class WildProgram {
 public:
  // Edges of the entity's clock may be left out where it says that they change nothing.
  enum class Clocks : std::uint8_t { all, needed };

  WildProgram(std::uint32_t seed, Clocks clocks);
  ~WildProgram() { model_->final(); }

  // Throws PinFault.
  void run(int actions);

  std::uint64_t steps() const { return pins_.steps(); }
  std::uint64_t stops() const { return stops_; }
  std::uint64_t latches_compared() const { return latches_compared_; }

 private:
  // What every segment of a run stops at: the flags word of each is bent to it.
  struct StopOn {
    std::uint8_t mask{};
    bool on_change{}, on_release{}, brakes{};
  };

  std::uint32_t word() { return static_cast<std::uint32_t>(random_()); }
  std::uint32_t below(std::uint32_t n) { return word() % n; }
  bool chance(std::uint32_t one_in) { return below(one_in) == 0; }
  std::uint32_t any_word();
  std::uint32_t any_slope() { return chance(4) ? 0 : 1u << (14 + below(18)); }
  std::uint32_t any_rate();

  void clock(std::uint32_t count = 1);
  void change_inputs();
  const char* judge();
  void stop();
  void brake(std::uint8_t end_stops);
  void judge_end_stops(const char*& reason);
  bool brake_is_over();

  std::uint32_t access(std::uint32_t address, bool writes, std::uint32_t value,
                       unsigned select = 0xF);
  std::uint32_t read(std::uint32_t address) { return access(address, false, 0); }
  void write(std::uint32_t address, std::uint32_t value);
  void note(std::uint32_t address, std::uint32_t value);
  void note_command(const registers::step_generator::Command& command);
  bool note_guard(std::uint32_t address, std::uint32_t value);
  void expect(bool holds, const char* claim) const;

  void act();
  void append_segment();
  void write_part_of_a_word();
  void write_guard();
  void write_position();
  void compare_snapshot();
  void compare_stop();
  void switch_motors();
  void come_to_rest();

  std::mt19937 random_;
  bool all_clocks_;
  std::unique_ptr<VerilatedContext> context_ = std::make_unique<VerilatedContext>();
  std::unique_ptr<Vstep_generator> model_ = std::make_unique<Vstep_generator>(context_.get());
  MotorPinWatch pins_;
  std::uint64_t now_ = 10'000;
  StopOn stop_on_;
  std::uint32_t line_ticks_ = 0;  // of the last segment, as far as known

  struct Inputs {
    std::uint8_t end_stops{}, emergency{}, start{};
    bool operator==(const Inputs&) const = default;
  };
  Inputs inputs_;  // in the last edge

  // What the next edge sees of software.
  registers::step_generator::Command command_{};
  std::optional<std::int32_t> placed_;
  std::size_t placed_axis_ = 0;
  bool idle_when_written_ = false, refused_by_bus_ = false;

  // Why no step may follow the clock before.
  const char* forbidden_ = nullptr;
  bool stopped_ = false, braking_ = false, stop_begins_ = false;
  std::uint8_t began_brake_ = 0;
  std::uint64_t braked_clocks_ = 0;
  std::uint32_t brake_slope_ = 1718;
  std::uint32_t slope_age_ = 0;
  std::uint32_t watchdog_ = 0;
  std::uint64_t watchdog_deadline_ = 0;

  std::uint64_t stops_ = 0, latches_compared_ = 0;
  MotorPinWatch::Positions snapshot_{}, stop_positions_{};
  std::uint64_t snapshot_clock_ = 0, stop_clock_ = 0, clock_offset_ = 0;
  bool stop_is_known_ = false, brake_may_last_ = false;
};

}  // namespace tests
