// SPDX-License-Identifier: Apache-2.0
// The probe alone: its rhythm in the duty, and its verdict on readings that answer it or do not.
#include "thermal/probe.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <set>
#include <vector>

#include "machine/machine.hpp"

namespace {

using thermal::Duty;
using thermal::HeaterModel;
using thermal::Probe;

constexpr Duty holding = 22'000;  // about a third of full power
constexpr int updates = 10;  // of a window
constexpr std::int32_t update_ms = 100, window_ms = 1'000;

struct Probed : testing::Test {
  // The reading in thousandths of a degree, by the time in s and by what the rhythm should bring.
  using Reading = std::function<double(double, double)>;

  Probe probe{machine::machine.hotend.model};
  std::vector<Duty> duties;
  static constexpr std::int32_t lost = 900;  // mK/s, which the duty without the rhythm gives
  std::int32_t before = 0;  // expected answer at the end of the last window
  double time = 0, lowest = 0, highest = 0;  // lowest and highest expected answer, thousandths

  // The window of the first verdict, or -1.
  int run(int windows, const Reading& reading, bool settled = true, std::int32_t melted = 0) {
    bool unanswered = false;
    for (int window = 0; window < windows; ++window) {
      double sum = 0;
      for (int i = 0; i < updates; ++i) {
        duties.push_back(probe.modulate(settled, holding));
        probe.follow(update_ms);
        unanswered = probe.is_unanswered_for_long() || unanswered;
        time += update_ms / 1'000.0;
        const double answer = probe.expected_answer().count();
        lowest = std::min(lowest, answer);
        highest = std::max(highest, answer);
        sum += reading(time, answer);
      }
      const std::int32_t answer = probe.expected_answer().count();
      const auto mean = static_cast<std::int32_t>(std::lround(sum / updates));
      unanswered =
          probe.is_unanswered(mean, 0, lost + answer - before, melted, window_ms) || unanswered;
      before = answer;
      if (unanswered) return window;
    }
    return -1;
  }
};

const auto frozen = [](double, double) { return 205'000.0; };
const auto alive = [](double, double answer) { return 205'000.0 + answer; };

TEST_F(Probed, leaves_the_duty_alone_until_the_heater_has_settled) {
  EXPECT_EQ(run(100, frozen, false), -1);
  EXPECT_TRUE(std::ranges::all_of(duties, [](Duty duty) { return duty == holding; }));
}

TEST_F(Probed, gives_and_takes_the_same_heat) {
  run(18 * 20, alive);
  double sum = 0;
  for (const Duty duty : duties) sum += duty - holding;
  EXPECT_LT(std::abs(sum / static_cast<double>(duties.size())), 0.01 * holding);
  EXPECT_NE(*std::ranges::max_element(duties), holding);
}

TEST_F(Probed, moves_the_hotend_by_half_a_degree_and_no_more) {
  run(200, alive);
  EXPECT_GT(highest - lowest, 350);
  EXPECT_LT(highest - lowest, 650);
}

// Otherwise something periodic could stay opposite to it.
TEST_F(Probed, has_no_half_as_long_as_the_next_but_one) {
  run(60, alive);
  std::set<std::size_t> lengths;
  std::size_t length = 0;
  for (std::size_t i = 1; i < duties.size(); ++i) {
    ++length;
    if ((duties[i] > holding) == (duties[i - 1] > holding)) continue;
    lengths.insert(length);
    length = 0;
  }
  EXPECT_GE(lengths.size(), 3U);
}

TEST_F(Probed, finds_a_frozen_sensor_within_nineteen_windows_of_the_freeze) {
  EXPECT_EQ(run(100, alive), -1);
  const double reading = 205'000.0 + probe.expected_answer().count();
  const int found = run(100, [reading](double, double) { return reading; });
  EXPECT_GE(found, 8);
  EXPECT_LE(found, 19);
}

TEST_F(Probed, takes_the_weakest_heater_and_the_strongest_for_alive) {
  for (const double part : {0.5, 0.6, 1.0, 1.3, 2.0}) {
    EXPECT_EQ(run(200, [part](double, double answer) { return 205'000 + part * answer; }), -1)
        << part;
  }
}

TEST_F(Probed, finds_a_sensor_that_answers_by_a_tenth) {
  EXPECT_NE(run(100, [](double, double answer) { return 205'000 + 0.1 * answer; }), -1);
}

TEST_F(Probed, takes_a_drift_or_a_wave_for_no_frozen_sensor) {
  EXPECT_EQ(run(200, [](double seconds, double) { return 205'000 - 20 * seconds; }), -1);
  for (const double period : {4.0, 6.0, 9.0, 12.0, 18.0}) {
    EXPECT_EQ(run(300,
                  [period](double seconds, double answer) {
                    return 205'000 + answer + 150 * std::sin(2 * M_PI * seconds / period);
                  }),
              -1)
        << period;
  }
}

// The filament could cancel the rhythm: what is still then may be chance, unless it stays so.
TEST_F(Probed, looks_longer_in_much_filament) {
  int window = 0;
  int found = -1;
  for (; window < 19 && found < 0; ++window) {
    if (run(1, frozen, true, window / 4 % 2 == 0 ? 600 : 0) >= 0) found = window;
  }
  EXPECT_EQ(found, -1) << "sooner than it takes when it lasts";
  for (; window < 80 && found < 0; ++window) {
    if (run(1, frozen, true, window / 4 % 2 == 0 ? 600 : 0) >= 0) found = window;
  }
  EXPECT_NE(found, -1) << "never, though it lasts";
}

TEST_F(Probed, looks_longer_when_the_fan_changes) {
  EXPECT_EQ(run(30, alive), -1);
  probe.disturb();
  EXPECT_EQ(run(17, frozen), -1);
  EXPECT_NE(run(30, frozen), -1);
}

// A target that is put off in the middle of a half must not leave heat that is never given.
TEST_F(Probed, expects_no_answer_to_heat_that_is_not_given) {
  run(20, alive);
  for (int i = 0; i < 3'000; ++i) probe.follow(update_ms);
  EXPECT_LT(std::abs(probe.expected_answer().count()), 20);
}

TEST_F(Probed, begins_again_after_the_heater_was_away_from_its_target) {
  EXPECT_EQ(run(16, frozen), -1);
  EXPECT_EQ(run(1, frozen, false), -1);
  EXPECT_EQ(run(16, frozen), -1);
}

TEST(probe, has_room_in_any_duty) {
  Probe probe{machine::machine.hotend.model};
  for (const int duty : {0, 1, 500, 32'768, 65'000, 65'534, 65'535}) {
    std::int64_t sum = 0;
    constexpr int windows = 18;
    for (int window = 0; window < windows; ++window) {
      const int given = probe.modulate(true, static_cast<Duty>(duty));
      sum += given - duty;
      probe.follow(window_ms);
      probe.is_unanswered(205'000, 0, 900, 0, window_ms);
    }
    EXPECT_LE(std::abs(sum / windows), std::min(duty, thermal::full_duty - duty)) << duty;
  }
}

TEST(probe, says_nothing_of_a_heater_that_is_not_described) {
  Probe probe{thermal::no_heater_model};
  for (int window = 0; window < 200; ++window) {
    EXPECT_EQ(probe.modulate(true, holding), holding);
    probe.follow(window_ms);
    EXPECT_FALSE(probe.is_unanswered(205'000, 0, 900, 0, window_ms));
  }
}

}  // namespace
