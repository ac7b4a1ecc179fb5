// SPDX-License-Identifier: Apache-2.0
// The temperature converter: settings of its conversions and the newest reading of each sensor.
#include "drivers/temperature_converter.hpp"

#include <algorithm>

#include "platform/bus.hpp"
#include "registers/heater_control_registers.hpp"
#include "registers/temperature_converter_registers.hpp"
#include "units/loop_bound.hpp"

namespace drivers {
namespace {

namespace registers = ::registers::temperature_converter;

constexpr std::int64_t longest_cycles = registers::Discharge::cycles_max;
constexpr std::int64_t cycles_per_tick = ::registers::heater_control::tick_cycles;

std::uint32_t cycles_of(units::Microseconds time, units::Hertz clock) {
  const std::int64_t cycles = time.count() * clock.count() / 1'000'000;
  return static_cast<std::uint32_t>(std::clamp<std::int64_t>(cycles, 0, longest_cycles));
}

}  // namespace

void TemperatureConverter::start(const ConverterSettings& settings) {
  stop();
  platform::write(registers::Discharge{.cycles = cycles_of(settings.discharge, clock_)});
  platform::write(registers::Timeout{.cycles = cycles_of(settings.longest_charge, clock_)});
  platform::write(registers::Pause{.cycles = cycles_of(settings.pause, clock_)});
  platform::write(registers::ShortLimit{.cycles = settings.short_limit});
  platform::write(
      registers::Control{.enable = true,
                         .references = settings.references,
                         .dither_cycles = settings.dither_cycles,
                         .more_charges = std::clamp<std::uint32_t>(settings.charges, 1, 256) - 1});
}

void TemperatureConverter::stop() {
  auto control = platform::read<registers::Control>();
  control.enable = false;
  platform::write(control);
}

bool TemperatureConverter::refused_settings() const {
  return platform::read<registers::SettingsLock>().refused;
}

thermal::SensorReading TemperatureConverter::reading(std::size_t channel) const {
  // A conversion takes milliseconds, so that at most one ends between the two looks at the status,
  // and none in the round after that.
  units::LoopBound<2> looks;
  for (;;) {
    looks.next();
    const auto status = platform::read<registers::Status>(channel);
    const thermal::SensorReading reading{
        .state = status.state,
        .conversions = static_cast<std::uint8_t>(status.conversions),
        .thermistor = platform::read<registers::Thermistor>(channel).cycles,
        .reference_low = platform::read<registers::ReferenceLow>(channel).cycles,
        .reference_high = platform::read<registers::ReferenceHigh>(channel).cycles,
        .age = units::Milliseconds(platform::read<registers::Age>(channel).ticks * cycles_per_tick *
                                   1'000 / clock_.count())};
    if (platform::read<registers::Status>(channel).conversions == status.conversions) {
      return reading;
    }
  }
}

}  // namespace drivers
