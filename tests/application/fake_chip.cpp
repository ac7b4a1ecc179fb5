// SPDX-License-Identifier: Apache-2.0
// Registers of the fake chip, and the seam of the bus.
#include "tests/application/fake_chip.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "platform/boot_loader.hpp"
#include "platform/bus.hpp"
#include "registers/end_stops_registers.hpp"
#include "registers/fan_registers.hpp"
#include "registers/identity_registers.hpp"
#include "registers/step_generator_registers.hpp"
#include "registers/temperature_converter_registers.hpp"
#include "registers/timer_registers.hpp"
#include "registers/uart_registers.hpp"

namespace application_test {
namespace {

namespace steps = registers::step_generator;
namespace heat = registers::heater_control;
namespace sense = registers::temperature_converter;

FakeChip* chip = nullptr;

constexpr double counts_per_ohm = 6.03;  // 16 charges of 68 nF to half the supply at 8 MHz
constexpr double room_c = 25.0;

// Which element of an array of registers an address is, or a number beyond it.
template <class Register>
std::size_t index_of(std::uint32_t address) {
  const std::uint32_t first = Register::address_of(0);
  return address < first ? Register::count : (address - first) / 4;
}

double clocks_of(double ticks, double rate, double acceleration) {
  const double end = std::sqrt(std::max(rate * rate + 2 * acceleration * ticks, 1e-18));
  return 2 * ticks / (rate + end);
}

}  // namespace

FakeChip::FakeChip() {
  word(steps::Override::address) = 1u << 16;
  chip = this;
}
FakeChip::~FakeChip() {
  if (chip == this) chip = nullptr;
}

std::uint32_t FakeChip::duty_address(std::size_t channel) {
  return heat::Duty::address_of(channel);
}

std::uint32_t FakeChip::end_stops() const {
  if (!end_stops_work) return 0;
  std::uint32_t triggered = end_stops_stuck;
  for (std::size_t axis = 0; axis < 3; ++axis)
    triggered |= (mechanical[axis] <= 0 ? 1u : 0u) << axis;
  return triggered;
}

std::uint32_t FakeChip::thermistor_count(std::size_t channel) const {
  const double kelvin = heaters[channel].celsius + 273.15;
  const double ohms = 100'000 * std::exp(4066.0 * (1 / kelvin - 1 / 298.15));
  return static_cast<std::uint32_t>(ohms * counts_per_ohm);
}

// Throws where no register can be: a chip would trap there.
std::size_t FakeChip::place_of(std::uint32_t address) {
  constexpr std::uint32_t first = 0xF000'0000, bytes_of_peripheral = 0x1000;
  const std::size_t peripheral = (address - first) / bytes_of_peripheral;
  const std::size_t place = address % bytes_of_peripheral / 4;
  if (address < first || peripheral >= peripherals || place >= words_of_peripheral)
    throw std::out_of_range("no register has the address " + std::to_string(address));
  return peripheral * words_of_peripheral + place;
}

std::uint64_t FakeChip::alarm() const {
  using namespace registers;
  return std::uint64_t{word(timer::CompareHigh::address)} << 32 | word(timer::CompareLow::address);
}

bool FakeChip::wakes() const {
  using namespace registers;
  if (time >= alarm()) return true;
  const auto interrupts = uart::Interrupts::decode(word(uart::Interrupts::address));
  const auto ends = uart::LineEnds::decode(word(uart::LineEnds::address));
  const bool line_waits = std::ranges::any_of(to_firmware, [&](char byte) {
    const auto value = static_cast<unsigned char>(byte);
    return value == ends.first || value == ends.second;
  });
  return (interrupts.receive_threshold != 0 &&
          to_firmware.size() >= interrupts.receive_threshold) ||
         (interrupts.on_line_end && line_waits);
}

std::uint32_t FakeChip::read(std::uint32_t address) {
  time += 2;
  using namespace registers;
  if (address == identity::Magic::address) {
    return identity::Magic{identity::Magic::Word::stepfabric}.encode();
  }
  if (address == identity::Clock::address) return clock_hz;
  if (address == identity::Motion::address)
    return identity::Motion{.axes = 5, .queue_depth = 32}.encode();
  if (address == uart::Status::address) {
    return uart::Status{.receive_level = static_cast<std::uint32_t>(
                            std::min<std::size_t>(to_firmware.size(), 1023)),
                        .transmit_space = 512,
                        .transmit_idle = true}
        .encode();
  }
  if (address == uart::Data::address) {
    if (to_firmware.empty()) return 0;
    const auto byte = static_cast<std::uint8_t>(to_firmware.front());
    to_firmware.pop_front();
    return uart::Data{
        .byte = byte, .valid = true, .gap = std::exchange(gap_before_next_byte, false)}
        .encode();
  }
  if (address == timer::TimeLow::address) {
    time_high_ = static_cast<std::uint32_t>(time >> 32);
    return static_cast<std::uint32_t>(time);
  }
  if (address == timer::TimeHigh::address) return time_high_;
  if (address == end_stops::Status::address)
    return end_stops::Status{.triggered = end_stops()}.encode();
  if (address == steps::Build::address) return steps::Build{.axes = 5, .queue_depth = 32}.encode();
  if (address == steps::Status::address) {
    advance_motion(clocks_per_status_read);
    const auto level = static_cast<std::uint32_t>(queue_.size());
    return steps::Status{.moving = moving_,
                         .idle = !moving_ && queue_.empty(),
                         .stopped = stopped_,
                         .level = level,
                         .free = 32 - level}
        .encode();
  }
  if (address == steps::MotorEnable::address) return motors;
  // Without slopes.
  if (address == steps::Scale::address) return word(steps::Override::address);
  if (address == steps::StopCause::address) {
    return steps::StopCause{.end_stops = stop_end_stops_,
                            .software = stopped_by_software_,
                            .watchdog = stopped_by_watchdog_}
        .encode();
  }
  for (const std::size_t axis :
       {index_of<steps::SnapshotPosition>(address), index_of<steps::StopPosition>(address),
        index_of<steps::Position>(address)}) {
    if (axis < position.size()) return static_cast<std::uint32_t>(position[axis]);
  }
  if (const std::size_t i = index_of<heat::Status>(address); i < heaters.size()) {
    return heat::Status{.permitted = true,
                        .minimum_locked = true,
                        .maximum_locked = true,
                        .hot_locked = true,
                        .settle_locked = true,
                        .tripped = heaters[i].tripped}
        .encode();
  }
  if (address == heat::Supply::address) {
    supply_closed();
    return supply_.encode();
  }
  if (const std::size_t i = index_of<sense::Status>(address); i < heaters.size()) {
    using State = sense::Status::State;
    const auto state = time < first_reading     ? State::never
                       : heaters[i].open_sensor ? State::open
                                                : State::ok;
    return sense::Status{.state = state,
                         .conversions = static_cast<std::uint32_t>(time / (clock_hz / 16)) & 0xFFu}
        .encode();
  }
  if (const std::size_t i = index_of<sense::Thermistor>(address); i < heaters.size()) {
    return thermistor_count(i);
  }
  if (index_of<sense::ReferenceLow>(address) < heaters.size()) {
    return static_cast<std::uint32_t>(470 * counts_per_ohm);
  }
  if (index_of<sense::ReferenceHigh>(address) < heaters.size()) {
    return static_cast<std::uint32_t>(10'000 * counts_per_ohm);
  }
  return word(address);
}

void FakeChip::write(std::uint32_t address, std::uint32_t value) {
  time += 2;
  word(address) = value;
  if (address == registers::uart::Data::address) from_firmware.push_back(static_cast<char>(value));
  if (address == registers::fan::Duty::address) fan_duty = value;
  if (address == steps::MotorEnable::address) motors = value;
  if (address == heat::Feed::address) feed(heat::Feed::decode(value).key);
  if (address == heat::Supply::address) switch_supply(heat::Supply::decode(value).key);
  if (address == steps::Command::address) command(value);
  if (address == steps::SegmentCommit::address) commit();
  if (const std::size_t axis = index_of<steps::Position>(address); axis < position.size()) {
    position[axis] = static_cast<std::int32_t>(value);
  }
}

void FakeChip::feed(heat::Feed::Key key) {
  using Key = heat::Feed::Key;
  const auto expected = second_key_is_next_ ? Key::second : Key::first;
  if (key != expected) ++wrong_watchdog_feeds;
  second_key_is_next_ = !second_key_is_next_;
  if (!second_key_is_next_) ++watchdog_feeds;
}

bool FakeChip::supply_closed() {
  for (const Heater& heater : heaters) {
    if (supply_.closed && heater.tripped) open_supply(&heat::Supply::trip_opened);
  }
  return supply_.closed;
}

void FakeChip::open_supply(bool heat::Supply::* cause) {
  supply_ = {};
  if (cause != nullptr) supply_.*cause = true;
}

void FakeChip::switch_supply(heat::Supply::Key key) {
  using Key = heat::Supply::Key;
  if (key == Key::close) {
    supply_ = {.closed = !supply_refuses, .refused = supply_refuses};
  }
  if (key == Key::open) supply_.closed = false;
}

void FakeChip::command(std::uint32_t value) {
  const auto wanted = steps::Command::decode(value);
  if (wanted.flush) queue_.clear();
  if (wanted.stop) stop(0, true);
  if (wanted.acknowledge_stop) stopped_ = false;
  if (wanted.feed_watchdog) ++motion_watchdog_feeds;
}

void FakeChip::stop(std::uint32_t end_stops, bool software) {
  queue_.clear();
  moving_ = false;
  stopped_ = true;
  stop_end_stops_ = end_stops;
  stopped_by_software_ = software;
}

void FakeChip::stop_by_watchdog() {
  stop(0, false);
  stopped_by_watchdog_ = true;
}

void FakeChip::commit() {
  const auto flags = steps::SegmentFlags::decode(word(steps::SegmentFlags::address));
  const auto wide = [this](std::uint32_t low, std::uint32_t high) {
    return (std::uint64_t{word(high)} << 32) | word(low);
  };
  Segment segment;
  segment.continues = flags.continues_line;
  segment.ends_motion = flags.ends_motion;
  segment.stop_mask = flags.stop_mask;
  segment.line_ticks = word(steps::SegmentLineTicks::address);
  segment.ticks = word(steps::SegmentTicks::address);
  segment.rate = std::ldexp(
      static_cast<double>(wide(steps::SegmentRateLow::address, steps::SegmentRateHigh::address)),
      -64);
  segment.acceleration = std::ldexp(
      static_cast<double>(static_cast<std::int64_t>(
          wide(steps::SegmentAccelerationLow::address, steps::SegmentAccelerationHigh::address))),
      -84);
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const std::int64_t count = word(steps::SegmentSteps::address_of(axis));
    segment.steps[axis] = (flags.backward >> axis & 1u) != 0 ? -count : count;
  }
  queue_.push_back(segment);
}

void FakeChip::advance(std::uint32_t clocks) {
  time += clocks;
  advance_motion(clocks);
  advance_heat(static_cast<double>(clocks) / clock_hz);
}

void FakeChip::advance_motion(std::uint32_t clocks) {
  double left = std::ldexp(clocks, -16) * word(steps::Override::address);
  while (left > 0 && !stopped_) {
    if (!moving_) {
      if (queue_.empty()) return;
      if (!queue_.front().continues) line_tick_ = 0;
      line_ = queue_.front();
      queue_.pop_front();
      segment_end_tick_ = line_tick_ + line_.ticks;
      segment_time_ = clocks_of(static_cast<double>(line_.ticks), line_.rate, line_.acceleration);
      segment_time_left_ = segment_time_;
      moving_ = true;
    }
    if (segment_time_left_ > left) {
      segment_time_left_ -= left;
      const double ticks_left =
          static_cast<double>(line_.ticks) * segment_time_left_ / segment_time_;
      walk_to(segment_end_tick_ - static_cast<std::int64_t>(std::ceil(ticks_left)));
      return;
    }
    left -= segment_time_left_;
    walk_to(segment_end_tick_);
    if (stopped_) return;
    moving_ = false;
    if (queue_.empty() && !line_.ends_motion) ++underruns;
  }
}

// Of the line, since its begin.
std::int64_t FakeChip::steps_until(std::size_t axis, std::int64_t line_tick) const {
  return line_.steps[axis] * line_tick / line_.line_ticks;
}

void FakeChip::walk_to(std::int64_t line_tick) {
  if (line_tick <= line_tick_) return;
  const std::int64_t last = tick_of_stop(line_tick);
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const std::int64_t steps = steps_until(axis, last) - steps_until(axis, line_tick_);
    position[axis] += static_cast<std::int32_t>(steps);
    mechanical[axis] += steps;
  }
  line_tick_ = last;
  if (const std::uint32_t hit = line_.stop_mask & end_stops(); hit != 0) stop(hit, false);
}

// The first tick, at least one from here, after which an end stop that ends the line is closed; at
// most `last_tick`. An axis moves to one side only: towards its end stop it closes once, and away
// from it the first tick is the one at which it is most closed.
std::int64_t FakeChip::tick_of_stop(std::int64_t last_tick) const {
  if (line_.stop_mask == 0 || !end_stops_work) return last_tick;
  if ((line_.stop_mask & end_stops_stuck) != 0) return line_tick_ + 1;
  std::int64_t first = last_tick;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if ((line_.stop_mask >> axis & 1u) == 0) continue;
    const std::int64_t begin = mechanical[axis] - steps_until(axis, line_tick_);
    const auto closed = [&](std::int64_t tick) { return begin + steps_until(axis, tick) <= 0; };
    if (closed(line_tick_ + 1)) return line_tick_ + 1;
    if (!closed(first)) continue;
    std::int64_t open = line_tick_ + 1;
    while (first - open > 1) {
      const std::int64_t middle = open + (first - open) / 2;
      (closed(middle) ? first : open) = middle;
    }
  }
  return first;
}

void FakeChip::advance_heat(double seconds) {
  for (std::size_t i = 0; i < heaters.size(); ++i) {
    Heater& heater = heaters[i];
    const double power = supply_closed() && !heater.tripped ? heater_duty(i) / 65'535.0 : 0.0;
    heater.arriving_power += (power - heater.arriving_power) * seconds / heater.lag_seconds;
    heater.celsius += seconds * (heater.arriving_power * heater.celsius_per_second_at_full_power -
                                 heater.loss_per_second * (heater.celsius - room_c));
  }
}

}  // namespace application_test

namespace platform {

bool enter_boot_loader() {
  auto& chip = *application_test::chip;
  if (chip.has_boot_loader) ++chip.boot_loader_entries;
  return chip.has_boot_loader;
}

std::uint32_t bus_read(std::uint32_t address) { return application_test::chip->read(address); }
void bus_write(std::uint32_t address, std::uint32_t value) {
  application_test::chip->write(address, value);
}

}  // namespace platform
