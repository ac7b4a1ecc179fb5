// SPDX-License-Identifier: Apache-2.0
// Pauses of a heater, in which its block cools down: a reading that falls faster than that of any
// described heater, or than this one has lost before, drifts.
#pragma once

#include <cstdint>

#include "thermal/heater_model.hpp"

namespace thermal {

// With the heat on, a drift looks like a weaker heater; without heat there is nothing that it could
// look like but loss. Only for heaters that get hot fast: a slower one is watched well enough
// without, and would lose too much time.
class Coast {
 public:
  // The model must outlive it.
  explicit constexpr Coast(const HeaterModel& model) : model_(&model) {}

  // Of an update.
  struct State {
    std::int32_t celsius{};  // mK
    std::int32_t below{};  // the target, in mK
    bool full{};  // all of the heat is wanted
    bool held{};  // the target, since it was set
    std::int32_t milliseconds{};
  };
  // With each update while a temperature is wanted: true while the heater is to pause, for 12 s at
  // most. It pauses once at a hot start and half way, 10 K or more below a target that has not been
  // held yet, the latter after 8 s of full heat; and anywhere where it needs more heat than a
  // moment ago, 8 s or more after the last pause, and twice as much after each one for
  // such a doubt, up to 64 s, until a target is reached.
  bool pause(const State& state);
  // Of a window of the comparison.
  struct Window {
    Slopes slopes;
    std::int32_t celsius{};  // mK
    std::int32_t noise{};  // from end to end, in mK
    std::int32_t milliseconds{};
  };
  // With each window while a temperature is wanted: true if the reading falls too fast in a pause,
  // or does not answer it.
  bool add(const Window& window);

  bool is_pausing() const { return pausing_; }
  // Since a pause has begun, until the heat after it is felt.
  bool is_recovering() const { return recovering_; }
  // Whether a heater so far below its target may pause.
  bool watches(std::int32_t below) const;
  // No temperature is wanted, or there is none.
  void restart();
  // Another heater may be mounted.
  void forget() { *this = Coast(*model_); }

 private:
  static constexpr std::int32_t shortest_wait = 8'000;  // ms

  bool is_due(const State& state);
  void begin();
  void suspect(const Slopes& slopes);
  void doubt(const Window& window);
  bool show_power(const Slopes& slopes);
  bool is_unanswered(const Slopes& slopes) const;
  std::int32_t answered_power(const Slopes& slopes) const;
  std::int32_t late_heat(const Slopes& slopes) const;
  std::int32_t room() const;
  std::int32_t least_lost(std::int32_t celsius) const;
  std::int32_t lost_before(const Slopes& slopes) const;
  std::int32_t most_more(const Slopes& slopes) const;
  std::int32_t most_fall(const Window& window) const;
  void learn(const Window& window, std::int32_t fall);

  const HeaterModel* model_;
  bool begun_ = false;  // a temperature was wanted at the last update
  bool pausing_ = false, recovering_ = false;
  // Since another heater may have been mounted.
  bool paused_at_start_ = false, paused_in_heat_ = false;
  std::int32_t wait_ = shortest_wait;  // full heat before the next pause, ms
  std::int32_t heated_ = 0;  // with full heat since the last one, ms
  std::int32_t paused_ = 0;  // ms
  // Of the pause: mK beyond what a heater loses, the sum of the falls in mK/s, and the windows that
  // are judged.
  std::int32_t excess_ = 0, fallen_ = 0, windows_ = 0;
  // The least that fan and filament take in it, in mK/s: the block feels more of it later.
  std::int32_t carried_least_ = 0;
  // What was lost in a pause, of which to fan and filament by the model, in mK/s, and how hot it
  // was then, in mK; 0: not known.
  std::int32_t lost_ = 0, carried_ = 0, lost_at_ = 0;
  // What the model does not explain of the slope with much heat: a mean, in mK/s.
  std::int32_t fast_ = 0;
  bool is_compared_ = false, may_drift_ = true;
  // The last window with heat that shows: the slope without losses, and the heat of the model, in
  // mK/s; 0: there was none.
  std::int32_t warmed_ = 0, heating_ = 0;
  // Of this heater: its power, of the nominal one with 8 fractional bits, and what it shows of it.
  std::int32_t power_ = 256, shown_ = 0;
  std::int32_t showing_left_ = 0;  // windows
  // What its power does not explain of the slope, and what fan and filament take: means over the
  // last windows, in mK/s.
  std::int32_t reference_ = 0, carried_reference_ = 0;
  bool is_referenced_ = false;
  // What is missing of it beyond what may, in mK; the pause waits for its time.
  std::int32_t doubt_ = 0;
  bool doubts_ = false;
  bool held_ = false;  // the target, at the last update
  std::int32_t calm_windows_ = 0;  // of the hold
  std::int32_t since_pause_ = 0;  // ms
  std::int32_t last_fall_ = 0;  // mK/s
  // The room is no warmer, in mK.
  std::int32_t coldest_seen_ = 1'000'000;
};

}  // namespace thermal
