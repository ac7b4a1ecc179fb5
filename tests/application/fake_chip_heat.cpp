// SPDX-License-Identifier: Apache-2.0
// Heaters, their supply and their sensors of the fake chip.
#include "tests/application/fake_chip.hpp"

#include <cmath>

#include "registers/heater_control_registers.hpp"

namespace application_test {
namespace {

namespace heat = registers::heater_control;

constexpr double room_c = 25.0;

}  // namespace

std::uint32_t FakeChip::count_of(double ohms) {
  constexpr double counts_per_ohm = 6.03;  // 16 charges of 68 nF to half the supply at 8 MHz
  return static_cast<std::uint32_t>(ohms * counts_per_ohm);
}

double FakeChip::thermistor_ohms(std::size_t channel) const {
  const double kelvin = heaters[channel].celsius + 273.15;
  return 100'000 * std::exp(4066.0 * (1 / kelvin - 1 / 298.15));
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
  if (key == Key::close) supply_ = {.closed = !supply_refuses, .refused = supply_refuses};
  if (key == Key::open) supply_.closed = false;
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
