// SPDX-License-Identifier: Apache-2.0
// Finds a signal's pull in the rows that the build takes from constraints/signals.csv.
#include "sim/machine/board_signals.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace machine {
namespace {

using devices::Pull;

struct SignalPull {
  std::string_view signal;
  Pull pull;
};

constexpr std::array signal_pulls{
#include "signal_pulls.inc"
};

}  // namespace

Pull pull_of(std::string_view signal) {
  const auto* found = std::ranges::find(signal_pulls, signal, &SignalPull::signal);
  if (found == signal_pulls.end()) throw std::out_of_range("no signal " + std::string(signal));
  return found->pull;
}

devices::SensorPulls sensor_pulls() {
  return {.resistor_pins = pull_of("sensor_resistor"), .sense_pin = pull_of("sensor_sense")};
}

}  // namespace machine
