// SPDX-License-Identifier: Apache-2.0
// What the stepper calls on the chip, here.
#include "tests/software_stepping/world.hpp"

#include <algorithm>
#include <stdexcept>

#include "drivers/registers/end_stops_registers.hpp"
#include "drivers/registers/step_pins_registers.hpp"
#include "drivers/registers/timer_registers.hpp"
#include "platform/bus.hpp"
#include "platform/processor.hpp"
#include "software_stepping/interrupts.hpp"

namespace software_stepping_test {
namespace {

World the_world;
std::uint32_t compare_low = 0;

constexpr std::uint64_t bus_clocks = 3;

}  // namespace

World& world() { return the_world; }
void make_world() { the_world = World(); }

void World::run(software_stepping::Stepper& stepper, std::uint64_t until) {
  while (compare <= until) {
    now = std::max(now, compare) + latency;
    software_stepping::on_timer(
        stepper.tick(), [&](software_stepping::Attention reason) { stepper.attend(reason); });
  }
  now = std::max(now, until);
}

}  // namespace software_stepping_test

namespace platform {

std::uint32_t clocks() { return static_cast<std::uint32_t>(software_stepping_test::world().now++); }

std::uint32_t bus_read(std::uint32_t address) {
  auto& world = software_stepping_test::world();
  world.now += software_stepping_test::bus_clocks;
  if (address != registers::end_stops::Status::address) throw std::logic_error("no such register");
  return registers::end_stops::Status{.triggered = world.triggered}.encode();
}

void bus_write(std::uint32_t address, std::uint32_t value) {
  auto& world = software_stepping_test::world();
  world.now += software_stepping_test::bus_clocks;
  namespace pins = registers::step_pins;
  namespace timer = registers::timer;
  switch (address) {
    case pins::Step::address:
      world.step = value;
      break;
    case pins::Direction::address:
      world.direction = value;
      break;
    case timer::CompareLow::address:
      software_stepping_test::compare_low = value;
      return;
    case timer::CompareHigh::address:
      world.compare = std::uint64_t{value} << 32 | software_stepping_test::compare_low;
      return;
    default:
      throw std::logic_error("no such register");
  }
  world.pulses.watch(world.now, world.step, world.direction);
}

}  // namespace platform

namespace software_stepping {

std::uint64_t long_clocks() {
  const std::uint64_t read = software_stepping_test::world().now;
  software_stepping_test::world().now += 5;
  return read;
}
WithoutInterrupts::WithoutInterrupts() = default;
WithoutInterrupts::~WithoutInterrupts() {}

}  // namespace software_stepping
