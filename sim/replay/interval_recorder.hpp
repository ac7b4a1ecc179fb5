// SPDX-License-Identifier: Apache-2.0
// Divides a simulation into intervals between snapshots.
#pragma once

#include <functional>
#include <memory>

#include "sim/replay/interval.hpp"

namespace replay {

class IntervalRecorder {
 public:
  // An interval is as long as `length` clocks, or longer until a snapshot can be taken.
  IntervalRecorder(sim::Clock length, std::function<void(Interval&&)> take)
      : length_(length), take_(std::move(take)) {}

  // A snapshot can be taken now.
  bool wants_snapshot(sim::Clock now) const {
    return !open_ || now >= interval_.start->clock + length_;
  }
  // Ends the present interval, and begins the next one. The inputs are those that were put last.
  void put_snapshot(Snapshot snapshot);

  // The pins from this clock on, whether they differ or not.
  void put_inputs(sim::Clock clock, const sim::InputPins& pins);
  void put_outputs(sim::Clock clock, sim::OutputPins pins);

  // Something was done to the chip that no pin shows: what has been recorded since the last
  // snapshot cannot be replayed.
  void discard();
  // The simulation ends at this clock: so does the last interval, without a snapshot.
  void finish(sim::Clock clock);

  // Of all intervals that have ended.
  sim::Clock recorded_clocks() const { return recorded_clocks_; }

 private:
  void hand_over(sim::Clock clock, std::shared_ptr<const Snapshot> end);

  sim::Clock length_;
  std::function<void(Interval&&)> take_;
  Interval interval_;
  sim::InputPins inputs_;
  sim::OutputPins outputs_;
  bool open_ = false;
  std::size_t intervals_ = 0;
  sim::Clock recorded_clocks_ = 0;
};

}  // namespace replay
