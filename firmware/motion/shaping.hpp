// SPDX-License-Identifier: Apache-2.0
// Input shaping and linear advance, between planner and step generator: replaces the planner's
// segments by one for each slot of time.
#pragma once

#include <cstdint>
#include <optional>

#include "motion/planner.hpp"
#include "motion/shaping_filter.hpp"
#include "motion/timeline.hpp"

namespace motion {

// A slot lasts 2^n clocks exactly: 1 to 2 ms, at least 2^14 clocks, or twice that where a slow mode
// makes a shaper long. Its steps end each axis at the step nearest to its
// shaped position, so that nothing adds up, and are spread evenly over it.
class Shaping {
 public:
  // A segment, or none that should be handed over now. `again`: there may be more at once, after a
  // segment, or where a line of the planner did not complete its slot.
  struct Output {
    std::optional<Segment> segment{};
    bool again{};
  };

  // To be called once, before all others.
  void set_timing(const StepTiming& timing);
  // How fast E may be with what linear advance adds to it.
  void set_limits(const Limits& limits);
  // Only at rest. False, and nothing done, where a shaper's frequency is out of range.
  bool configure(const ShapingSettings& settings);
  const ShapingSettings& settings() const { return settings_; }
  // Anything to be done: otherwise the planner's segments are to be handed over as they are.
  bool active() const { return active_; }
  std::uint32_t slot_clocks() const { return 1u << slot_bits_; }
  units::Microseconds slot_time() const { return slot_time_; }  // rounded up
  // By which all axes are late on average.
  std::uint32_t delay_clocks() const { return filter_.slots_late() << slot_bits_; }
  // Over which linear advance takes the speed of E; 0 without it.
  std::uint32_t speed_window_clocks() const { return filter_.speed_window() << slot_bits_; }

  // `stocked`: the generator has enough for now. The end of a motion is not handed over then, so
  // that a line that comes in time goes on from it.
  // A line with end stops begins from rest, and is handed over as it is.
  Output next_segment(Planner& planner, units::Microseconds now, bool stocked);
  // Everything that was planned has been handed over to the step.
  bool at_rest() const { return at_rest_; }
  // Forgets it, after the step generator was stopped.
  void clear();

 private:
  enum class Progress : std::uint8_t { complete, again, wait };
  void begin(const Segment& segment);
  Progress complete_slot(Planner& planner, units::Microseconds now, bool stocked);
  void note(const units::PerAxis<FinePosition>& position);
  Segment emit();

  void limit_steps();

  units::Hertz clock_{};
  int slot_bits_{};
  units::Microseconds slot_time_{};
  units::PerAxis<std::int32_t> most_steps_{};  // in a slot, by drivers and M203 E
  units::PerAxis<std::uint32_t> most_rates_{};  // of the drivers, steps/s
  std::uint32_t extruder_rate_{};  // by M203
  ShapingSettings settings_{};
  bool active_{};

  Timeline timeline_;
  ShapingFilter filter_;
  units::PerAxis<FinePosition> made_{};  // whole steps
  Sample input_{};  // where the planned motion is
  std::uint64_t elapsed_{};  // clocks of the segment
  std::uint32_t missing_{};  // clocks to the end of the slot
  std::uint32_t resting_slots_{};  // since the end of the planned motion
  bool input_rests_{true};
  bool between_segments_{true};
  bool at_rest_{true};
  bool passes_{};  // a line with end stops
};

}  // namespace motion
