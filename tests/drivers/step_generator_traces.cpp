// SPDX-License-Identifier: Apache-2.0
// Writes what the Verilated step generator does with its pins in four scenes, as tables for
// pictures. Usage: step_generator_traces DIRECTORY
#include <Vstep_generator.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "drivers/step_generator.hpp"
#include "platform/bus.hpp"
#include "registers/step_generator_registers.hpp"
#include "tests/drivers/verilated_bus.hpp"

namespace {

namespace registers = ::registers::step_generator;
using motion::Segment;

constexpr std::uint64_t rate(double ticks_per_clock) {
  return static_cast<std::uint64_t>(ticks_per_clock * 18446744073709551616.0);
}
constexpr std::int64_t acceleration(double ticks_per_clock_squared) {
  return static_cast<std::int64_t>(ticks_per_clock_squared * 1048576.0 * 18446744073709551616.0);
}

// A line at a constant rate in one segment that ends motion.
Segment line(std::int32_t x, std::int32_t y, double ticks_per_clock) {
  const auto ticks = static_cast<std::uint32_t>(std::max(std::abs(x), std::abs(y)));
  return {.steps = {x, y, 0, 0},
          .line_ticks = ticks,
          .ticks = ticks,
          .ends_motion = true,
          .rate = rate(ticks_per_clock)};
}

// One scene: a fresh chip, and a table with a row for each clock in which a pin changes. Columns:
// clock, X step, X direction, Y step, end stop, X position, and the ticks per 1000 clocks between
// the last two steps of X. Every change has a row before it too, so that lines drawn are upright.
class Scene {
 public:
  Scene(const std::filesystem::path& file, const drivers::GuardTimings& guard) : out_(file) {
    generator_.configure({guard, guard, guard, guard}, 1);
    platform::write(registers::MotorEnable{.axes = 0b11111});
    generator_.permit_motion(false);
    chip_.after_clock = [this] { watch(); };
  }
  ~Scene() { out_ << row_ << '\n'; }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  drivers::StepGenerator& generator() { return generator_; }
  void append(const Segment& segment) {
    if (!generator_.append(segment)) throw std::logic_error("segment refused");
  }
  void begin() {
    generator_.permit_motion(true);
    while (!chip_->moving) chip_.clock();
    began_ = chip_.now();
    row_.clear();
    last_pins_.clear();
    watch();
  }
  void run_until(std::uint64_t clock) {
    while (chip_.now() < began_ + clock) chip_.clock();
  }
  void set_end_stop(bool triggered) { chip_->end_stops = triggered; }

 private:
  void watch() {
    const bool step = (chip_->step & 1u) != 0;
    const auto now = static_cast<std::int64_t>(chip_.now() - began_);
    const bool backward = (chip_->direction & 1u) != 0;
    if (step && !last_step_) {
      position_ += backward ? -1 : 1;
      if (rises_++ > 0) tick_rate_ = 1000.0 / static_cast<double>(now - last_rise_);
      last_rise_ = now;
    }
    last_step_ = step;
    char pins[96];
    std::snprintf(pins, sizeof pins, " %d %d %d %d %d %.3f", step, backward,
                  (chip_->step >> 1u & 1u) != 0, chip_->end_stops & 1u, position_, tick_rate_);
    const std::string row = std::to_string(now) + pins;
    if (began_ != 0 && pins != last_pins_) {
      if (!row_.empty()) out_ << row_ << '\n';
      out_ << row << '\n';
    }
    last_pins_ = pins;
    row_ = row;
  }

  std::ofstream out_;
  tests::VerilatedPeripheral<Vstep_generator> chip_{registers::base};
  drivers::StepGenerator generator_;
  std::uint64_t began_ = 0;
  bool last_step_ = false;
  int rises_ = 0, position_ = 0;
  std::int64_t last_rise_ = 0;
  double tick_rate_ = 0;
  std::string last_pins_, row_;
};

constexpr drivers::GuardTimings short_guard{10, 10, 10, 10};

// X 60 steps, Y 25: up, even, down, at 4e-7 ticks per clock^2.
void draw_ramp(const std::filesystem::path& file) {
  Scene scene(file, short_guard);
  Segment part = line(60, 25, 0.0005);
  part.ends_motion = false;
  part.ticks = 20;
  part.acceleration = acceleration(4e-7);
  scene.append(part);
  part.continues_line = true;
  part.acceleration = 0;
  part.rate = rate(0.00403);
  scene.append(part);
  part.acceleration = acceleration(-4e-7);
  part.ends_motion = true;
  scene.append(part);
  scene.begin();
  scene.run_until(24000);
}

// X turns back every four steps at 0.02 ticks per clock under the guard of an A4988 at 50 MHz.
void draw_reversal(const std::filesystem::path& file) {
  Scene scene(file, drivers::GuardTimings::of(drivers::a4988, units::Hertz{50'000'000}));
  for (int i = 0; i < 3; ++i) scene.append(line(i % 2 == 0 ? 4 : -4, 2, 0.02));
  scene.begin();
  scene.run_until(1500);
}

void draw_hold(const std::filesystem::path& file) {
  Scene scene(file, short_guard);
  scene.generator().set_slopes(1u << 20u, 1u << 20u);  // 4096 clocks from 1 to 0
  scene.append(line(60, 25, 0.004));
  scene.begin();
  scene.run_until(5000);
  scene.generator().set_override(0);
  scene.run_until(12000);
  scene.generator().set_override(65536);
  scene.run_until(30000);
}

// Once at once, once along the brake's slope, both from the same speed.
void draw_stop(const std::filesystem::path& file, bool brakes) {
  Scene scene(file, short_guard);
  scene.generator().set_slopes(1u << 20u, 1u << 20u);
  Segment segment = line(60, 25, 0.004);
  segment.stop_mask = 1;
  segment.stop_brakes = brakes;
  scene.append(segment);
  scene.begin();
  scene.run_until(5000);
  scene.set_end_stop(true);
  scene.run_until(12000);
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count != 2) {
    std::fprintf(stderr, "usage: step_generator_traces DIRECTORY\n");
    return 2;
  }
  const std::filesystem::path directory = arguments[1];
  draw_ramp(directory / "ramp.txt");
  draw_reversal(directory / "reversal.txt");
  draw_hold(directory / "hold.txt");
  draw_stop(directory / "stop.txt", false);
  draw_stop(directory / "brake.txt", true);
  return 0;
}
