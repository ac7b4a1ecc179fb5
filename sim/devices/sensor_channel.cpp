// SPDX-License-Identifier: Apache-2.0
// Connects a thermistor input to the chip's charge and sense pins.
#include "sim/devices/sensor_channel.hpp"

#include <cmath>

namespace devices {

SensorChannel::SensorChannel(std::size_t channel, sim::ClockRate rate, ThermistorInput& input,
                             sim::InputPins& pins)
    : channel_(channel), rate_(rate), input_(input), pins_(pins) {
  show(0);
}

void SensorChannel::pins_changed(sim::Clock now, sim::OutputPins pins, sim::OutputPins) {
  input_.set_pins(rate_.seconds(now), pins.sensor_drive(channel_), pins.sensor_level(channel_));
  show(now);
}

void SensorChannel::wake(sim::Clock now) { show(now); }

void SensorChannel::set_fault(sim::Clock now, SensorFault fault) {
  input_.set_fault(rate_.seconds(now), fault);
  show(now);
}

void SensorChannel::scale_capacitor(sim::Clock now, double factor) {
  if (factor > 0) {
    input_.scale_capacitor(rate_.seconds(now), factor);
  } else {
    input_.lose_capacitor(rate_.seconds(now));
  }
  show(now);
}

void SensorChannel::show(sim::Clock now) {
  const double seconds = rate_.seconds(now);
  const auto mask = static_cast<std::uint8_t>(1U << channel_);
  pins_.sense =
      static_cast<std::uint8_t>(input_.sense(seconds) ? pins_.sense | mask : pins_.sense & ~mask);
  const double next = input_.next_change();
  next_wake_ = sim::never;
  if (next > seconds && std::isfinite(next)) {
    const auto clock = static_cast<sim::Clock>(std::ceil(next * rate_.hertz()));
    next_wake_ = clock > now ? clock : now + 1;
  }
}

}  // namespace devices
