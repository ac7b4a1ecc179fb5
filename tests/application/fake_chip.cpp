// SPDX-License-Identifier: Apache-2.0
// Registers of the fake chip, and the bus functions of the firmware.
#include "tests/application/fake_chip.hpp"

#include <algorithm>
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

// Which element of an array of registers an address is, or a number beyond it.
template <class Register>
std::size_t index_of(std::uint32_t address) {
  const std::uint32_t first = Register::address_of(0);
  return address < first ? Register::count : (address - first) / 4;
}

// A function of its own, so that the look-up needs no stack for the message.
[[noreturn, gnu::noinline]] void fail_without_register(std::uint32_t address) {
  throw std::out_of_range("no register has the address " + std::to_string(address));
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
  for (std::size_t axis = 0; axis < 3; ++axis) {
    triggered |= (end_stop_closed(axis, mechanical[axis]) ? 1u : 0u) << axis;
  }
  if (probe_triggers(mechanical)) triggered |= 1u << probe_input;
  const std::uint32_t levels = filament_is_out ? 0 : 1u << filament_input;
  const std::uint32_t active_low = word(registers::end_stops::Polarity::address);
  const std::uint32_t enabled = word(registers::end_stops::Enable::address);
  triggered |= (levels ^ active_low) & enabled & 1u << filament_input;
  return triggered;
}

bool FakeChip::probe_triggers(const std::array<std::int64_t, axes>& steps) const {
  if (!probe_mm) return false;
  std::array<double, 3> mm;
  for (std::size_t i = 0; i < mm.size(); ++i) {
    mm[i] = static_cast<double>(steps[i]) / steps_per_mm[i];
  }
  return mm[2] <= probe_mm(mm[0], mm[1]);
}

// Throws where no register can be: a chip would trap there.
std::size_t FakeChip::place_of(std::uint32_t address) {
  constexpr std::uint32_t first = 0xF000'0000, bytes_of_peripheral = 0x1000;
  const std::size_t peripheral = (address - first) / bytes_of_peripheral;
  const std::size_t place = address % bytes_of_peripheral / 4;
  if (address < first || peripheral >= peripherals || place >= words_of_peripheral) {
    fail_without_register(address);
  }
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
  if (address == slow_address) time += slow_clocks;
  using namespace registers;
  if (address == identity::Magic::address) {
    return identity::Magic{identity::Magic::Word::stepfabric}.encode();
  }
  if (address == identity::Clock::address) return clock_hz;
  if (address == identity::Motion::address) {
    return identity::Motion{.axes = 5, .queue_depth = 32}.encode();
  }
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
  if (address == end_stops::Status::address) {
    return end_stops::Status{.triggered = end_stops()}.encode();
  }
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
    return count_of(thermistor_ohms(i));
  }
  if (index_of<sense::ReferenceLow>(address) < heaters.size()) return count_of(470);
  if (index_of<sense::ReferenceHigh>(address) < heaters.size()) return count_of(10'000);
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

void FakeChip::advance(std::uint32_t clocks) {
  time += clocks;
  advance_motion(clocks);
  advance_heat(static_cast<double>(clocks) / clock_hz);
}

}  // namespace application_test

namespace platform {

bool restart() { return false; }

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
