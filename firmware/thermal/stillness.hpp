// SPDX-License-Identifier: Apache-2.0
// Whether a reading stands still while the heat that it should follow goes up and down.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>

#include "thermal/course.hpp"

namespace thermal {

// Compares the course of the last windows with those that the model expects: of the rhythm alone,
// of all the heat that is given, each less what the filament takes, for that may be true, or half
// of it, or nothing, where a nozzle is clogged. All less their straight line, since what the room
// does is slow. The reading is judged by two parts: the one that goes with the rhythm (least
// squares on the expected answer and its slope, for the lags may differ), in which little noise is
// left, and the rest, which shows a disturbance that happens to cancel the rhythm.
class Stillness {
 public:
  static constexpr std::size_t longest = longest_course;  // windows
  // In thousandths of a degree. What is given and taken is per window, as the sensor feels it.
  struct Window {
    std::int32_t celsius{};
    std::int32_t answer{};  // expected of the rhythm
    std::int32_t given{};
    std::int32_t taken{};  // by filament
    std::int32_t spread{};  // of the conversions from lowest to highest
  };

  // `rhythm`: windows of one rise and fall of the expected answer.
  explicit constexpr Stillness(std::int32_t rhythm)
      : is_slow_(2 * rhythm > static_cast<std::int32_t>(slow[0].length)) {}

  // True if the reading is of a frozen sensor. This does not look at the courses: each call of
  // look_further() does at one of them, in turn, for all of them at once take a processor long.
  // Where there are fewer calls before the next window, they go on with the course that is next.
  bool add(const Window& window);
  bool look_further();
  // There is no rhythm.
  void restart() { seen_ = still_ = 0; }
  // What cools is not known well enough from here on.
  void disturb() { undisturbed_ = 0; }

 private:
  using Course = std::array<std::int32_t, longest>;

  struct Limits {
    std::size_t length;  // windows
    // Of the expected course, in percent (root mean square): what may go with it, and the rest.
    std::int32_t with_rhythm, rest;
  };
  using LimitTable = std::array<Limits, 3>;
  // Over more windows the noise counts for less. Of a slow rhythm one rise and fall must do, which
  // a single disturbance could cancel; but its reading can be smoothed.
  static constexpr LimitTable quick{{{18, 16, 28}, {27, 20, 46}, {36, 20, 57}}};
  static constexpr LimitTable slow{{{18, 9, 14}, {27, 13, 24}, {longest, 16, 38}}};
  // Whatever cools, in this many windows in a row.
  static constexpr std::size_t lasting_length = 18;
  static constexpr std::int32_t lasting_limit = 40;

  static ConstValues last(const Course& course, std::size_t length) {
    return ConstValues(course).last(length);
  }
  void copy_last(Values course, Values answer) const;
  const LimitTable& limits() const { return is_slow_ ? slow : quick; }
  bool is_still(const Limits& limits) const;
  std::int64_t noise(std::size_t length) const;  // estimated energy in the last windows
  struct Energies {
    std::int64_t course, answer;
  };
  bool is_still(const Limits& limits, ConstValues course, ConstValues answer,
                const Energies& energies) const;
  bool is_still_for_now() const;

  bool is_slow_;
  std::size_t seen_ = 0;  // windows since the rhythm began, at most `longest`, as the following
  std::size_t undisturbed_ = 0;  // since disturb()
  std::size_t still_ = 0;  // in a row
  std::size_t unjudged_ = 0;  // of limits(), with the last window
  std::size_t judged_ = std::tuple_size_v<LimitTable> - 1;  // the last one of them
  // By course, not by window: each loop goes over one or two of them.
  struct Courses {
    Course celsius{}, answer{}, given{}, taken{}, spread{};
  } windows_;
};

}  // namespace thermal
