// SPDX-License-Identifier: Apache-2.0
// The switch's contact, intact or broken.
#include "sim/devices/end_stop.hpp"

#include <algorithm>

namespace devices {

namespace {

constexpr double least_closing_seconds = 1e-3, most_closing_seconds = 5e-3;
constexpr double least_opening_seconds = 0.5e-3, most_opening_seconds = 3e-3;
constexpr double least_contact_seconds = 10e-6, most_contact_seconds = 300e-6;

std::array<std::int64_t, 4> on_axis(std::size_t axis, std::int64_t value) {
  std::array<std::int64_t, 4> values{};
  values[axis] = value;
  return values;
}

}  // namespace

EndStop::EndStop(std::size_t axis, std::size_t input, sim::ClockRate rate, sim::InputPins& inputs,
                 std::int64_t position, EndStopFault fault, std::uint64_t seed)
    : EndStop(SwitchPlace{.weights = on_axis(axis, 1), .at = 0}, input, rate, inputs,
              on_axis(axis, position), fault, seed) {}

EndStop::EndStop(const SwitchPlace& place, std::size_t input, sim::ClockRate rate,
                 sim::InputPins& inputs, const std::array<std::int64_t, 4>& positions,
                 EndStopFault fault, std::uint64_t seed)
    : place_(place),
      positions_(positions),
      input_(input),
      rate_(rate),
      inputs_(inputs),
      fault_(fault),
      random_(seed),
      at_rest_closed_(is_pressed()) {
  show(at_rest_closed_);
}

void EndStop::stepped(const StepEdge& edge) {
  if (edge.axis >= positions_.size() || place_.weights[edge.axis] == 0) return;
  positions_[edge.axis] = edge.position;
  if (is_pressed() == at_rest_closed_) return;
  at_rest_closed_ = !at_rest_closed_;
  show(at_rest_closed_);
  if (fault_ != EndStopFault::bounces) return;
  bounces_until_ =
      edge.clock + (at_rest_closed_ ? between(least_closing_seconds, most_closing_seconds)
                                    : between(least_opening_seconds, most_opening_seconds));
  next_wake_ = edge.clock + between(least_contact_seconds, most_contact_seconds);
}

void EndStop::wake(sim::Clock now) {
  if (now >= bounces_until_) return show(at_rest_closed_);
  show(!closed());
  next_wake_ = std::min(now + between(least_contact_seconds, most_contact_seconds), bounces_until_);
}

bool EndStop::is_pressed() const {
  switch (fault_) {
    case EndStopFault::never_closes:
      return false;
    case EndStopFault::never_opens:
      return true;
    case EndStopFault::none:
    case EndStopFault::bounces:
      break;
  }
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < positions_.size(); ++i) sum += place_.weights[i] * positions_[i];
  return sum <= place_.at;
}

void EndStop::show(bool closed) {
  const auto mask = static_cast<std::uint8_t>(1U << input_);
  inputs_.end_stops =
      static_cast<std::uint8_t>(closed ? inputs_.end_stops | mask : inputs_.end_stops & ~mask);
}

sim::Clock EndStop::between(double least_seconds, double most_seconds) {
  const double part = static_cast<double>(random_() >> 11) * 0x1p-53;
  return rate_.clocks(least_seconds + part * (most_seconds - least_seconds));
}

}  // namespace devices
