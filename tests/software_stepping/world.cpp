// SPDX-License-Identifier: Apache-2.0
// What the stepper calls on the chip, here.
#include "tests/software_stepping/world.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "platform/bus.hpp"
#include "platform/processor.hpp"
#include "registers/end_stops_registers.hpp"
#include "registers/step_pins_registers.hpp"
#include "registers/timer_registers.hpp"
#include "software_stepping/interrupts.hpp"

namespace software_stepping_test {
namespace {

World the_world;
std::uint32_t compare_low = 0;

constexpr std::uint64_t bus_clocks = 3;
// From the timer's deadline to the edge.
constexpr std::uint64_t entry_clocks = 8;

using software_stepping::Attention;
using software_stepping::Block;
using software_stepping::Stepper;
using software_stepping::Tick;

// Any numbers will do.
constexpr software_stepping::Ways the_ways{
    .careful = 1, .watched = 11, .ramp = 2, .even = {3, 4, 5, 6}, .rest = {7, 8, 9, 10}};

void write_step(std::uint32_t pins) { platform::write(registers::step_pins::Step{pins & 0xFF}); }

// What tick.S does, in its order.
std::optional<Attention> next_block(Tick& tick) {
  Block& next = *tick.block->next;
  if (next.trap_base == 0) return Attention::block_ends;
  tick.block->trap_base = 0;
  tick.block = &next;
  tick.trap_base = next.trap_base;
  tick.left = next.ticks;
  if (next.begins_line == 0) return {};
  tick.errors = next.line.errors;
  world().now += 26 + 3 * next.line.hold_delay;
  platform::write(registers::step_pins::Direction{next.line.direction});
  return {};
}

std::optional<Attention> make_tick(Tick& tick) {
  if (tick.trap_base == the_ways.careful) return Attention::careful;
  World& world = software_stepping_test::world();
  if (tick.trap_base == the_ways.watched) {
    namespace end_stops = registers::end_stops;
    const std::uint32_t status = platform::read<end_stops::Status>().encode();
    if ((status & tick.block->watch) != 0) return Attention::careful;
  }
  const bool is_ramp =
      tick.block->watched_tick == the_ways.ramp + software_stepping::tick_entry_bytes;
  write_step(tick.pins);
  std::optional<Attention> attention;
  if (--tick.left == 0) {
    attention = next_block(tick);
  } else if (is_ramp) {
    Block& block = *tick.block;
    if (software_stepping::advance_short_interval(block.interval, block.mantissa, block.shift)) {
      block.interval_clocks = block.interval >> 16;
      block.interval_fraction = block.interval << 16;
    } else {
      attention = Attention::interval;
    }
  }
  world.now += 29 + 3 * tick.block->line.pulse_delay + (tick.block->line.pulse_delay != 0 ? 5 : 0);
  if (attention) {
    write_step(0);
    return attention;
  }
  const Block& block = *tick.block;
  tick.pins = block.line.leader;
  for (std::size_t i = 0; i < software_stepping::most_quick_followers; ++i) {
    if (block.line.steps[i] == 0) break;
    tick.errors[i] += block.line.steps[i];
    if (tick.errors[i] < 0) continue;
    tick.pins |= static_cast<std::uint32_t>(tick.errors[i]);
    tick.errors[i] -= block.line.ticks;
  }
  tick.fraction += block.interval_fraction;
  const std::uint32_t clocks =
      block.interval_clocks + (tick.fraction < block.interval_fraction ? 1 : 0);
  tick.deadline_low += clocks;
  if (tick.deadline_low < clocks) ++tick.deadline_high;
  const auto ahead = static_cast<std::int32_t>(tick.deadline_low - platform::clocks());
  write_step(0);
  if (ahead < block.near_clocks) {
    if (ahead < -static_cast<std::int32_t>(block.interval_clocks)) return Attention::late;
    world.now += static_cast<std::uint64_t>(std::max(ahead, block.near_clocks)) + 2;
    return make_tick(tick);
  }
  platform::write(registers::timer::CompareLow{tick.deadline_low});
  platform::write(registers::timer::CompareHigh{tick.deadline_high});
  return {};
}

}  // namespace

World& world() { return the_world; }
void make_world() { the_world = World(); }

void World::run(Stepper& stepper, std::uint64_t until) {
  while (compare <= until) {
    now = std::max(now, compare) + entry_clocks;
    if (const auto reason = make_tick(tick)) stepper.attend(*reason);
  }
  now = std::max(now, until);
}

}  // namespace software_stepping_test

namespace platform {

std::uint32_t clocks() { return static_cast<std::uint32_t>(software_stepping_test::world().now++); }

std::uint32_t bus_read(std::uint32_t address) {
  auto& world = software_stepping_test::world();
  world.now += software_stepping_test::bus_clocks;
  if (address == registers::step_pins::Direction::address) return world.direction;
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
      // The pins are raised and lowered by turns.
      if (world.step_writes++ % 2 == 0) world.ticks.push_back({world.now, value, world.direction});
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
bool has_come(std::uint64_t clock) { return long_clocks() >= clock; }
const Ways& ways() { return software_stepping_test::the_ways; }
void registers_to_tick() {}
void tick_to_registers() {}
WithoutInterrupts::WithoutInterrupts() = default;
WithoutInterrupts::~WithoutInterrupts() {}

}  // namespace software_stepping
