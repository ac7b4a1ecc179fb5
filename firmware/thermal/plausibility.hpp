// SPDX-License-Identifier: Apache-2.0
// Compares what a heater is given with what its sensor shows: heat that goes missing is a sensor
// that froze, drifts or has fallen out, or a heater that fails; unasked heat is a heater
// that sticks.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "thermal/ascent.hpp"
#include "thermal/coast.hpp"
#include "thermal/controller.hpp"
#include "thermal/demand.hpp"
#include "thermal/heater_model.hpp"
#include "thermal/probe.hpp"
#include "units/quantity.hpp"

namespace thermal {

// slope = power * rise * duty - loss * (losses of the model), with both factors somewhere within
// the tolerances of the description. Nothing is learnt that a fault could lead astray: of a grid of
// heaters within the tolerances those are ruled out that are too strong or too weak for what was
// measured, beyond draught and sag (parameter set estimation: Milanese, Vicino, Automatica 27,
// 1991). Each has a sum of the rise that is missing, and one of the rise that it cannot explain; a
// sum above the limit rules it out for ten minutes. No heater left: the sensor does not show what
// is heated. What rises more than the strongest heater explains, cooling or not, is summed up too,
// and is unasked for if the duty is 0 when the sum is above its limit. A window's mean leaves out
// its lowest and its highest conversion, and of three windows the middle one counts: a disturbed
// conversion is none, but a reading that jumps and stays is.
class Plausibility {
 public:
  enum class Finding : std::uint8_t {
    none,
    heat_missing,
    heat_unasked,
    sensor_frozen,
    sensor_implausible
  };

  // The model must outlive it.
  explicit constexpr Plausibility(const HeaterModel& model)
      : model_(&model), probe_(model), demand_(model), ascent_(model), coast_(model) {}

  // Every 100 ms or so. `duty` is what the heater was given since the last call, `elapsed` ago. No
  // temperature where the conversion has failed. Without a target the heater is off, and may cool
  // down as it likes.
  Finding update(std::optional<units::Millicelsius> measured, Duty duty,
                 std::optional<units::Millicelsius> target, const Cooling& cooling,
                 units::Milliseconds elapsed);
  // With each update while a temperature is wanted: 0 in place of `duty` while the heater pauses.
  Duty coast(const Coast::State& state, Duty duty) { return coast_.pause(state) ? Duty{0} : duty; }
  bool is_pausing() const { return coast_.is_pausing(); }
  // `duty` with the probe's rhythm.
  Duty probe(bool settled, Duty duty) { return probe_.modulate(settled, duty); }
  // What the rhythm adds to the temperature: the controller must not work against it.
  units::Millicelsius expected_answer() const { return probe_.expected_answer(); }

 private:
  static constexpr int steps = HeaterGrid::steps;
  // Against one heater of the grid, in mK.
  struct Evidence {
    std::int16_t missing{};
    std::int16_t surplus{};
  };

  // Means of a window.
  struct Window {
    std::int32_t celsius{};  // thousandths
    std::int32_t duty{};  // as it has come to the sensor
    std::int32_t milliseconds{};
  };

  void begin_window();
  Finding compare(const Window& raw, std::optional<units::Millicelsius> target,
                  const Cooling& cooling);
  std::int32_t filament_loss(const Cooling& cooling) const {
    return model_->filament_loss * (cooling.filament.count() / 64) / 16;
  }
  std::int32_t needed_to_hold(units::Millicelsius target) const;
  Slopes slopes_until(const Window& now, const Cooling& cooling) const;
  void watch_demand(const Slopes& slopes, const Window& now,
                    std::optional<units::Millicelsius> target);
  bool is_heat_missing(const Slopes& slopes, units::Millicelsius target, std::int32_t milliseconds);
  bool is_comparable(const Window& now, units::Millicelsius target);
  bool is_heat_unasked(const Slopes& slopes, bool wanted, std::int32_t milliseconds);

  const HeaterModel* model_;
  Probe probe_;
  Demand demand_;
  Ascent ascent_;
  Coast coast_;
  std::optional<units::Millicelsius> wanted_;  // what demand_ is about
  bool reached_ = false;  // since it is wanted
  std::array<bool, static_cast<std::size_t>(steps)> needs_too_much_{};  // by power
  std::array<Evidence, static_cast<std::size_t>(steps* steps)> heaters_{};
  std::int32_t arriving_ = 0, felt_ = 0;  // duty after one lag and after both, 4 fractional bits
  std::int32_t unasked_ = 0;  // mK
  std::int32_t noise_ = 0;  // mK from end to end, of the last windows
  std::uint8_t fan_ = 0;
  // Sums of the window under way, and how many updates it has.
  Window sum_{};
  std::int32_t updates_ = 0;
  std::int32_t lowest_ = std::numeric_limits<std::int32_t>::max();  // thousandths of a degree
  std::int32_t highest_ = std::numeric_limits<std::int32_t>::min();
  std::optional<units::Millicelsius> last_measured_;
  std::int32_t faulty_ = 0;  // ms since the last valid conversion
  std::int32_t resting_ = 0;  // ms since heat was wanted
  bool idle_ = true;  // the duty is 0 in this window
  std::array<Window, 2> raw_{};  // the latest
  int raw_windows_ = 0;
  std::optional<Window> before_;  // the middle of three
};

}  // namespace thermal
