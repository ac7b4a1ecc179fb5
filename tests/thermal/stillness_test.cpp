// SPDX-License-Identifier: Apache-2.0
// The verdict alone: readings that stand still, that live, and that a disturbance keeps still.
#include "thermal/stillness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>

namespace {

using thermal::Stillness;

constexpr std::int32_t quick_rhythm = 6, slow_rhythm = 18;  // windows
constexpr double swing = 130;  // thousandths of a degree, from the middle
constexpr double lost = 900;  // thousandths of a degree in a window

struct Judge {
  explicit Judge(std::int32_t windows) : rhythm(windows), stillness(windows) {}

  double answer_at(double window) const {
    return swing * std::sin(2 * std::numbers::pi * window / rhythm);
  }
  // The window of the first verdict, or -1. The reading by the window and the expected answer; the
  // filament takes as `taken` says, and the controller gives as much more.
  int run(
      int windows, const std::function<double(double, double)>& reading,
      const std::function<double(double)>& taken = [](double) { return 0.0; }) {
    for (int i = 0; i < windows; ++i) {
      const double given = lost + answer_at(now + 0.5) - answer_at(now - 0.5) + taken(now);
      bool still = stillness.add({.celsius = rounded(205'000 + reading(now, answer_at(now))),
                                  .answer = rounded(answer_at(now)),
                                  .given = rounded(given),
                                  .taken = rounded(taken(now))});
      for (int look = 0; look < looks; ++look) still = stillness.look_further() || still;
      if (still) return i;
      now += 1;
    }
    return -1;
  }
  static std::int32_t rounded(double value) {
    return static_cast<std::int32_t>(std::lround(value));
  }

  int rhythm;
  Stillness stillness;
  double now = 0;
  int looks = 9;  // between two windows
};

class Stillnesses : public testing::TestWithParam<std::int32_t> {};

TEST_P(Stillnesses, find_what_does_not_move_after_eighteen_windows) {
  Judge judge(GetParam());
  EXPECT_EQ(judge.run(30, [](double, double) { return 0.0; }), 17);
}

// One call that looks at all that there is to look at would take a processor too long.
TEST_P(Stillnesses, are_found_over_longer_times_with_one_look_a_window_three_windows_later) {
  Judge judge(GetParam());
  const auto reading = [](double window, double) { return window < 10 ? 400 * window : 4'000.0; };
  const int found = judge.run(90, reading);
  Judge late(GetParam());
  late.looks = 1;
  const int found_late = late.run(90, reading);
  EXPECT_GT(found, 18);
  EXPECT_LE(found_late, found + 3);
}

TEST_P(Stillnesses, find_what_freezes_in_eighteen_windows_more) {
  Judge judge(GetParam());
  EXPECT_EQ(judge.run(40, [](double, double answer) { return answer; }), -1);
  const double frozen = judge.answer_at(judge.now - 1);
  EXPECT_LE(judge.run(30, [frozen](double, double) { return frozen; }), 17);
}

TEST_P(Stillnesses, find_it_in_noise) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 15);
  Judge judge(GetParam());
  EXPECT_NE(judge.run(40, [&](double, double) { return noise(random); }), -1);
}

TEST_P(Stillnesses, take_a_weak_answer_for_alive) {
  for (const double part : {0.5, 0.6, 1.0, 2.0}) {
    Judge judge(GetParam());
    EXPECT_EQ(judge.run(300, [part](double, double answer) { return part * answer; }), -1) << part;
  }
}

// Half of the rhythm later or sooner by the lags.
TEST_P(Stillnesses, take_a_late_answer_for_alive) {
  for (const double part : {-0.25, 0.25}) {
    Judge judge(GetParam());
    EXPECT_EQ(
        judge.run(300, [&](double window,
                           double) { return 0.5 * judge.answer_at(window - part * judge.rhythm); }),
        -1)
        << part;
  }
}

// A disturbance that cancels the rhythm is seldom the same in all else.
TEST_P(Stillnesses, take_what_moves_otherwise_for_alive) {
  Judge judge(GetParam());
  EXPECT_EQ(judge.run(300,
                      [&](double window, double) {
                        return 120 * std::sin(2 * std::numbers::pi * window / judge.rhythm * 1.7);
                      }),
            -1);
  Judge slow(GetParam());
  EXPECT_EQ(slow.run(300, [](double window, double) { return 20 * window; }), -1) << "a ramp";
}

TEST_P(Stillnesses, say_nothing_soon_after_the_fan_has_changed) {
  Judge judge(GetParam());
  EXPECT_EQ(judge.run(17, [](double, double) { return 0.0; }), -1);
  judge.stillness.disturb();
  EXPECT_EQ(judge.run(17, [](double, double) { return 0.0; }), -1);
  EXPECT_EQ(judge.run(17, [](double, double) { return 0.0; }), 0);
}

TEST_P(Stillnesses, say_nothing_before_the_rhythm_has_run_long_enough) {
  Judge judge(GetParam());
  EXPECT_EQ(judge.run(17, [](double, double) { return 0.0; }), -1);
  judge.stillness.restart();
  EXPECT_EQ(judge.run(17, [](double, double) { return 0.0; }), -1);
}

INSTANTIATE_TEST_SUITE_P(of, Stillnesses, testing::Values(quick_rhythm, slow_rhythm),
                         [](const auto& rhythm) {
                           return rhythm.param == quick_rhythm ? "a_quick_rhythm" : "a_slow_rhythm";
                         });

// The controller gives what the filament takes, so the rhythm may be cancelled: it takes longer.
TEST(stillness, looks_longer_where_the_filament_takes_in_the_rhythm) {
  Judge judge(quick_rhythm);
  const auto taken = [](double window) { return std::fmod(window, 6) < 3 ? 600.0 : 0.0; };
  const int found = judge.run(80, [](double, double) { return 0.0; }, taken);
  EXPECT_GT(found, 30);
}

// One rise and fall proves less than three.
TEST(stillness, asks_more_of_a_slow_rhythm) {
  const auto little = [](double, double answer) { return 0.12 * answer; };
  Judge quick(quick_rhythm), slow(slow_rhythm);
  EXPECT_EQ(quick.run(18, little), 17);
  EXPECT_EQ(slow.run(18, little), -1);
}

}  // namespace
