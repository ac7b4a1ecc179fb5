// SPDX-License-Identifier: Apache-2.0
// Registers of the instant chip, and the bus functions of the firmware.
#include "tests/fuzz/instant_chip.hpp"

#include <algorithm>
#include <cmath>

#include "platform/boot_loader.hpp"
#include "platform/bus.hpp"
#include "registers/end_stops_registers.hpp"
#include "registers/fan_registers.hpp"
#include "registers/heater_control_registers.hpp"
#include "registers/identity_registers.hpp"
#include "registers/step_generator_registers.hpp"
#include "registers/temperature_converter_registers.hpp"
#include "registers/timer_registers.hpp"
#include "registers/uart_registers.hpp"
#include "tests/fuzz/property.hpp"

namespace fuzz {
namespace {

namespace steps = registers::step_generator;
namespace heat = registers::heater_control;
namespace sense = registers::temperature_converter;
namespace uart = registers::uart;
namespace timer = registers::timer;

constexpr std::uint32_t queue_depth = 32;

// As the application's tests have it: 16 charges of 68 nF to half the supply at 8 MHz.
std::uint32_t count_of(double ohms) {
  constexpr double counts_per_ohm = 6.03;
  return static_cast<std::uint32_t>(ohms * counts_per_ohm);
}

// Which element of an array of registers an address is, or a number beyond it.
template <class Register>
std::size_t index_of(std::uint32_t address) {
  const std::uint32_t first = Register::address_of(0);
  return address < first ? Register::count : (address - first) / 4;
}

constinit InstantChip the_chip;
constinit SerialLine the_line;

}  // namespace

InstantChip& instant_chip() { return the_chip; }
SerialLine& serial_line() { return the_line; }

// Where no register can be, a chip would trap.
std::size_t InstantChip::place_of(std::uint32_t address) {
  constexpr std::uint32_t first = 0xF000'0000, bytes_of_peripheral = 0x1000;
  const std::size_t peripheral = (address - first) / bytes_of_peripheral;
  const std::size_t place = address % bytes_of_peripheral / 4;
  if (address < first || peripheral >= peripherals || place >= words_of_peripheral) {
    fail("no register has the address {:#x}", address);
  }
  return peripheral * words_of_peripheral + place;
}

std::uint32_t InstantChip::heater_duty(std::size_t channel) const {
  return word(heat::Duty::address_of(channel));
}

void InstantChip::set_temperature(std::size_t channel, double celsius) {
  sensor_counts_[channel] =
      count_of(100'000 * std::exp(4066.0 * (1 / (celsius + 273.15) - 1 / 298.15)));
}

std::uint32_t InstantChip::end_stops() const {
  std::uint32_t closed = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) closed |= (mechanical[axis] <= 0 ? 1u : 0u) << axis;
  return closed;
}

std::uint32_t InstantChip::stop_cause() const {
  return steps::StopCause{.end_stops = stop_end_stops_, .software = stopped_by_software_}.encode();
}

std::uint32_t InstantChip::read(std::uint32_t address) {
  time += 2;
  switch (address) {
    case uart::Data::address: {
      std::string_view& bytes = the_line.to_firmware;
      if (bytes.empty()) return 0;
      const auto byte = static_cast<std::uint8_t>(bytes.front());
      bytes.remove_prefix(1);
      return uart::Data{.byte = byte, .valid = true}.encode();
    }
    case uart::Status::address:
      return uart::Status{.receive_level = static_cast<std::uint32_t>(the_line.to_firmware.size()),
                          .transmit_space = 512,
                          .transmit_idle = true}
          .encode();
    case timer::TimeLow::address:
      time_high_ = static_cast<std::uint32_t>(time >> 32);
      return static_cast<std::uint32_t>(time);
    case timer::TimeHigh::address:
      return time_high_;
    case steps::Status::address:
      return steps::Status{.idle = true, .stopped = stopped_, .free = queue_depth}.encode();
    case steps::Build::address:
      return steps::Build{.axes = axes, .queue_depth = queue_depth}.encode();
    case steps::MotorEnable::address:
      return motors;
    case steps::Scale::address:
      return word(steps::Override::address);  // without slopes
    case steps::StopCause::address:
      return stop_cause();
    case registers::end_stops::Status::address:
      return registers::end_stops::Status{.triggered = end_stops()}.encode();
    case heat::Supply::address:
      return heat::Supply{.closed = supply_closed}.encode();
    case registers::identity::Magic::address:
      return registers::identity::Magic{registers::identity::Magic::Word::stepfabric}.encode();
    case registers::identity::Clock::address:
      return clock_hz;
    case registers::identity::Motion::address:
      return registers::identity::Motion{.axes = axes, .queue_depth = queue_depth}.encode();
    default:
      break;
  }
  for (const std::size_t axis :
       {index_of<steps::SnapshotPosition>(address), index_of<steps::StopPosition>(address),
        index_of<steps::Position>(address)}) {
    if (axis < position.size()) return static_cast<std::uint32_t>(position[axis]);
  }
  if (index_of<heat::Status>(address) < channels) {
    return heat::Status{.permitted = true,
                        .minimum_locked = true,
                        .maximum_locked = true,
                        .hot_locked = true,
                        .settle_locked = true}
        .encode();
  }
  if (index_of<sense::Status>(address) < channels) {
    return sense::Status{.state = sense::Status::State::ok,
                         .conversions = static_cast<std::uint32_t>(time / (clock_hz / 16)) & 0xFFu}
        .encode();
  }
  if (const std::size_t channel = index_of<sense::Thermistor>(address); channel < channels) {
    return sensor_counts_[channel];
  }
  if (index_of<sense::ReferenceLow>(address) < channels) return count_of(470);
  if (index_of<sense::ReferenceHigh>(address) < channels) return count_of(10'000);
  return word(address);
}

void InstantChip::write(std::uint32_t address, std::uint32_t value) {
  time += 2;
  if (address == uart::Data::address) {
    the_line.from_firmware.push_back(static_cast<char>(value));
    return;
  }
  words_[place_of(address)] = value;
  if (address == steps::MotorEnable::address) motors = value;
  if (address == steps::Command::address) command(value);
  if (address == steps::SegmentCommit::address) commit();
  if (address == heat::Supply::address) {
    using Key = heat::Supply::Key;
    const Key key = heat::Supply::decode(value).key;
    if (key == Key::close || key == Key::open) supply_closed = key == Key::close;
  }
  if (const std::size_t axis = index_of<steps::Position>(address); axis < position.size()) {
    position[axis] = static_cast<std::int32_t>(value);
  }
}

void InstantChip::command(std::uint32_t value) {
  const auto wanted = steps::Command::decode(value);
  if (wanted.stop) {
    stopped_ = stopped_by_software_ = true;
    busy_until = time;
    stop_end_stops_ = 0;
  }
  if (wanted.acknowledge_stop) stopped_ = false;
}

// How long a segment would take, in clocks.
std::uint64_t InstantChip::segment_clocks() const {
  const auto wide = [this](std::uint32_t low, std::uint32_t high) {
    return std::uint64_t{word(high)} << 32 | word(low);
  };
  const double ticks = word(steps::SegmentTicks::address);
  const double rate = std::ldexp(
      static_cast<double>(wide(steps::SegmentRateLow::address, steps::SegmentRateHigh::address)),
      -64);
  const double acceleration = std::ldexp(
      static_cast<double>(static_cast<std::int64_t>(
          wide(steps::SegmentAccelerationLow::address, steps::SegmentAccelerationHigh::address))),
      -84);
  const double end = std::sqrt(std::max(rate * rate + 2 * acceleration * ticks, 1e-18));
  return static_cast<std::uint64_t>(std::min(2 * ticks / (rate + end), 1e13));
}

void InstantChip::commit() {
  if (stopped_) return;
  busy_until = std::max(busy_until, time) + segment_clocks();
  const auto flags = steps::SegmentFlags::decode(word(steps::SegmentFlags::address));
  if (!flags.continues_line) make_line(flags.backward, flags.stop_mask);
}

// Up to where the first of its end stops closes.
void InstantChip::make_line(std::uint32_t backward, std::uint32_t stop_mask) {
  std::array<std::int64_t, axes> made{};
  for (std::size_t axis = 0; axis < axes; ++axis) {
    const std::int64_t count = word(steps::SegmentSteps::address_of(axis));
    made[axis] = (backward >> axis & 1u) != 0 ? -count : count;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if ((stop_mask >> axis & 1u) == 0 || made[axis] == 0) continue;
    const std::int64_t here = mechanical[axis];
    if (here > 0 && here + made[axis] > 0) continue;
    // From a closed one it goes one step.
    const std::int64_t all = std::abs(made[axis]);
    const std::int64_t part = std::clamp<std::int64_t>(here, 1, all);
    for (std::int64_t& steps : made) steps = steps * part / all;
    stopped_ = true;
    stopped_by_software_ = false;
    busy_until = time;
  }
  for (std::size_t axis = 0; axis < axes; ++axis) {
    mechanical[axis] += made[axis];
    position[axis] += static_cast<std::int32_t>(made[axis]);
    lowest[axis] = std::min(lowest[axis], mechanical[axis]);
    highest[axis] = std::max(highest[axis], mechanical[axis]);
  }
  stop_end_stops_ = stopped_ ? end_stops() & stop_mask : 0;
  ++lines_made;
}

}  // namespace fuzz

namespace platform {

bool restart() { return false; }
bool enter_boot_loader() { return false; }
std::uint32_t bus_read(std::uint32_t address) { return fuzz::the_chip.read(address); }
void bus_write(std::uint32_t address, std::uint32_t value) { fuzz::the_chip.write(address, value); }

}  // namespace platform
