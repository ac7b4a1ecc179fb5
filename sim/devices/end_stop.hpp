// SPDX-License-Identifier: Apache-2.0
// An end stop switch: closed while its axis stands at 0 or below, or where else the motors bring
// what presses it. Its contact may bounce.
#pragma once

#include <array>
#include <random>

#include "sim/devices/step_edge.hpp"
#include "sim/devices/switch_place.hpp"
#include "sim/simulation/clock_rate.hpp"
#include "sim/simulation/device.hpp"

namespace devices {

// A contact that bounces does so for 1 to 5 ms when it closes and half a millisecond to 3 ms when
// it opens, with 10 to 300 us from edge to edge: micro switches by their data sheets and as
// measured by Ganssle, "A Guide to Debouncing" (2004), who found 1.6 ms on the average and 6.2 ms
// at most.
enum class EndStopFault : std::uint8_t { none, never_closes, never_opens, bounces };

class EndStop : public sim::Device, public StepListener {
 public:
  EndStop(std::size_t axis, std::size_t input, sim::ClockRate rate, sim::InputPins& inputs,
          std::int64_t position, EndStopFault fault = EndStopFault::none, std::uint64_t seed = 1);
  // Of several motors, which stand at `positions`.
  EndStop(const SwitchPlace& place, std::size_t input, sim::ClockRate rate, sim::InputPins& inputs,
          const std::array<std::int64_t, 4>& positions, EndStopFault fault, std::uint64_t seed);

  void stepped(const StepEdge& edge) override;
  void wake(sim::Clock now) override;
  bool closed() const { return (inputs_.end_stops >> input_ & 1) != 0; }

 private:
  bool is_pressed() const;
  void show(bool closed);
  sim::Clock between(double least_seconds, double most_seconds);

  SwitchPlace place_;
  std::array<std::int64_t, 4> positions_;
  std::size_t input_;
  sim::ClockRate rate_;
  sim::InputPins& inputs_;
  EndStopFault fault_;
  std::mt19937_64 random_;
  bool at_rest_closed_;  // when it has ceased to bounce
  sim::Clock bounces_until_ = 0;
};

}  // namespace devices
