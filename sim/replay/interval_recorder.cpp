// SPDX-License-Identifier: Apache-2.0
// From snapshot to snapshot.
#include "sim/replay/interval_recorder.hpp"

#include <utility>

namespace replay {

void IntervalRecorder::hand_over(sim::Clock clock, std::shared_ptr<const Snapshot> end) {
  open_ = false;
  interval_.number = ++intervals_;
  interval_.end_clock = clock;
  interval_.end = std::move(end);
  recorded_clocks_ += clock - interval_.start->clock;
  take_(std::exchange(interval_, {}));
}

void IntervalRecorder::put_snapshot(Snapshot snapshot) {
  auto shared = std::make_shared<const Snapshot>(std::move(snapshot));
  if (open_) hand_over(shared->clock, shared);
  open_ = true;
  outputs_ = shared->outputs;
  interval_.inputs = {{shared->clock, inputs_}};
  interval_.start = std::move(shared);
}

void IntervalRecorder::put_inputs(sim::Clock clock, const sim::InputPins& pins) {
  if (pins == inputs_) return;
  inputs_ = pins;
  if (open_) interval_.inputs.push_back({clock, pins});
}

void IntervalRecorder::put_outputs(sim::Clock clock, sim::OutputPins pins) {
  if (!open_ || pins == outputs_) return;
  outputs_ = pins;
  interval_.outputs.push_back({clock, pins});
}

void IntervalRecorder::discard() {
  open_ = false;
  interval_ = {};
}

void IntervalRecorder::finish(sim::Clock clock) {
  if (open_ && clock > interval_.start->clock) hand_over(clock, nullptr);
}

}  // namespace replay
