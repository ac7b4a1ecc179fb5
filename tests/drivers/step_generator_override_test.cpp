// SPDX-License-Identifier: Apache-2.0
// Feed hold and override: the same pulses in the same order, only at another time.
#include <cmath>
#include <random>
#include <vector>

#include "tests/drivers/step_generator_fixture.hpp"

namespace {

using motion::Segment;
using testing::ElementsAre;

constexpr std::uint32_t one = 65536;

class StepGeneratorOverrideTest : public tests::StepGeneratorFixture {
 protected:
  struct Edge {
    std::uint64_t clock{};
    std::uint32_t risen{}, direction{};
  };

  void SetUp() override {
    chip_.after_clock = [this] {
      const std::uint32_t risen = chip_->step & ~last_step_;
      last_step_ = chip_->step;
      if (risen != 0) edges_.push_back({chip_.now(), risen, chip_->direction});
    };
    use(shortest);
  }

  // A ramp up, a stretch at constant rate, a ramp down, and another line backward.
  void append_motion() {
    generator_.permit_motion(false);
    Segment part = line({4000, -3000, 1234, 7}, rate(0.001));
    part.ends_motion = false;
    part.ticks = 1000;
    part.acceleration = acceleration;
    append(part);
    part.continues_line = true;
    part.rate = rate(0.021);
    part.acceleration = 0;
    part.ticks = 2000;
    append(part);
    part.acceleration = -acceleration;
    part.ticks = 1000;
    append(part);
    append(line({-500, -500, 500, 0}, rate(0.01)));
    generator_.permit_motion(true);
  }

  std::vector<Edge> take_edges() {
    std::vector<Edge> taken;
    taken.swap(edges_);
    return taken;
  }

  static void expect_same_order(const std::vector<Edge>& actual,
                                const std::vector<Edge>& expected) {
    ASSERT_EQ(actual.size(), expected.size());
    for (std::size_t i = 0; i < actual.size(); ++i) {
      ASSERT_EQ(actual[i].risen, expected[i].risen) << i;
      ASSERT_EQ(actual[i].direction & actual[i].risen, expected[i].direction & expected[i].risen);
    }
  }

  // The largest acceleration of X that the edges of each of its lines show, in ticks per clock^2:
  // between edges some thousand clocks apart, where a clock more or less is a hundredth of it.
  static double largest_acceleration(const std::vector<Edge>& edges) {
    constexpr std::uint64_t apart = 6000;
    double largest = 0;
    std::vector<std::uint64_t> line;
    const auto measure = [&line, &largest] {
      for (std::size_t first = 0, second = 0, third = 0; first < line.size(); ++first) {
        while (second < line.size() && line[second] < line[first] + apart) ++second;
        if (second == line.size()) break;
        third = std::max(third, second);
        while (third < line.size() && line[third] < line[second] + apart) ++third;
        if (third == line.size()) break;
        const auto speed = [&line](std::size_t from, std::size_t to) {
          return static_cast<double>(to - from) / static_cast<double>(line[to] - line[from]);
        };
        const double time = static_cast<double>(line[third] - line[first]) / 2;
        largest = std::max(largest, std::abs(speed(second, third) - speed(first, second)) / time);
      }
      line.clear();
    };
    std::uint32_t direction = 0;
    for (const Edge& edge : edges) {
      if ((edge.risen & 1u) == 0) continue;
      if ((edge.direction & 1u) != direction) measure();
      direction = edge.direction & 1u;
      line.push_back(edge.clock);
    }
    measure();
    return largest;
  }

  // From 0.001 to 0.021 ticks per clock in 1000 ticks: (0.021^2 - 0.001^2) / 2000 per clock^2.
  static constexpr double ticks_per_clock2 = 2.2e-7, highest_ticks_per_clock = 0.021;
  static constexpr auto acceleration =
      static_cast<std::int64_t>(ticks_per_clock2 * 1048576.0 * 18446744073709551616.0);
  // With which the change of the scale alone takes no more than that.
  static constexpr auto slope_of_the_ramps =
      static_cast<std::uint32_t>(ticks_per_clock2 / highest_ticks_per_clock * 4294967296.0);
  std::uint32_t last_step_ = 0;
  std::vector<Edge> edges_;
};

TEST_F(StepGeneratorOverrideTest, makes_the_same_pulses_in_the_same_order_at_any_scale) {
  append_motion();
  run_until_idle();
  const auto plain = take_edges();
  const auto plain_clocks = plain.back().clock - plain.front().clock;
  for (const std::uint32_t percent : {10u, 37u, 99u, 100u, 101u, 150u, 200u, 233u, 300u}) {
    generator_.set_override_percent(percent);
    chip_.clock(2);
    append_motion();
    run_until_idle();
    const auto edges = take_edges();
    expect_same_order(edges, plain);
    const double clocks = static_cast<double>(edges.back().clock - edges.front().clock);
    const double expected = static_cast<double>(plain_clocks) * 100 / percent;
    EXPECT_NEAR(clocks, expected, 0.0005 * expected + 40) << percent << " %";
    if (percent == 100) {
      EXPECT_EQ(edges.back().clock - edges.front().clock, plain_clocks);
    }
  }
}

TEST_F(StepGeneratorOverrideTest, places_each_tick_within_a_base_clock_below_one_hundred_percent) {
  append(line({1000, 0, 0, 0}, rate(1.0 / 128)));
  run_until_idle();
  const auto plain = take_edges();
  generator_.set_override(one / 4);
  append(line({1000, 0, 0, 0}, rate(1.0 / 128)));
  run_until_idle();
  const auto slow = take_edges();
  for (std::size_t i = 1; i < plain.size(); ++i) {
    EXPECT_EQ(slow[i].clock - slow[i - 1].clock, 4 * (plain[i].clock - plain[i - 1].clock));
  }
}

TEST_F(StepGeneratorOverrideTest, holds_along_its_slope_and_goes_on_where_it_was) {
  append_motion();
  run_until_idle();
  const auto plain = take_edges();

  // 2^32 / 2^20 = 4096 clocks from 1 to 0.
  generator_.set_slopes(1u << 20u, 1u << 20u);
  append_motion();
  chip_.clock(120000);
  const auto before = generator_.snapshot().positions;
  generator_.set_override(0);
  chip_.clock(4000);
  EXPECT_FALSE(generator_.held());
  EXPECT_GT(generator_.scale(), 0);
  chip_.clock(100);
  EXPECT_TRUE(generator_.held());
  EXPECT_TRUE(generator_.moving());
  EXPECT_FALSE(generator_.idle());
  EXPECT_EQ(generator_.scale(), 0);
  const auto at_hold = generator_.snapshot().positions;
  // Half of 4096 clocks at 0.021 ticks per clock.
  EXPECT_NEAR(at_hold[0] - before[0], 43, 2);
  const auto edges_at_hold = edges_.size();
  chip_.clock(50000);
  EXPECT_EQ(edges_.size(), edges_at_hold);
  EXPECT_EQ(generator_.snapshot().positions, at_hold);

  generator_.set_override(one);
  run_until_idle();
  expect_same_order(take_edges(), plain);
  EXPECT_FALSE(generator_.held());
  EXPECT_EQ(generator_.counters().underruns, 0);
}

TEST_F(StepGeneratorOverrideTest, accelerates_no_more_than_the_ramps_whenever_the_scale_changes) {
  std::mt19937 random(1);
  generator_.set_slopes(slope_of_the_ramps, 1);
  append_motion();
  run_until_idle();
  EXPECT_NEAR(largest_acceleration(take_edges()), ticks_per_clock2, 0.02 * ticks_per_clock2);
  for (int run = 0; run < 12; ++run) {
    append_motion();
    while (!generator_.idle()) {
      const auto which = random() % 3;
      generator_.set_override(which == 0 ? 0 : which == 1 ? one : random() % one);
      chip_.clock(1000 + random() % 60'000);
    }
    EXPECT_LT(largest_acceleration(take_edges()), 1.02 * ticks_per_clock2) << run;
  }
}

TEST_F(StepGeneratorOverrideTest,
       comes_to_rest_in_four_times_the_longest_ramp_wherever_it_is_held) {
  constexpr auto longest =
      static_cast<std::uint64_t>(4 * highest_ticks_per_clock / ticks_per_clock2);
  generator_.set_slopes(slope_of_the_ramps, 1);
  for (std::uint32_t clocks = 5000; clocks < 320'000; clocks += 21'000) {
    append_motion();
    chip_.clock(clocks);
    generator_.set_override(0);
    const auto asked = chip_.now();
    while (!generator_.held() && !generator_.idle() && chip_.now() < asked + 2 * longest) {
      chip_.clock(100);
    }
    EXPECT_LT(chip_.now() - asked, longest) << clocks;
    generator_.set_override(one);
    run_until_idle();
  }
}

TEST_F(StepGeneratorOverrideTest, never_steps_faster_than_every_second_clock) {
  generator_.set_override_percent(300);
  for (const double ticks_per_clock : {0.1, 0.12, 0.2, 0.24, 0.3, 0.5}) {
    chip_.clock(10);
    take_edges();
    append(line({3000, 3000, -3000, 3000}, rate(ticks_per_clock)));
    run_until_idle();
    const auto edges = take_edges();
    ASSERT_EQ(edges.size(), 3000);
    for (std::size_t i = 1; i < edges.size(); ++i) {
      ASSERT_GE(edges[i].clock - edges[i - 1].clock, 2) << ticks_per_clock;
    }
    // As the header of the hardware says: 3, 2 or 1 times as fast.
    const double clocks = static_cast<double>(edges.back().clock - edges.front().clock);
    const double times = ticks_per_clock < 7.0 / 64 ? 3 : ticks_per_clock < 15.0 / 64 ? 2 : 1;
    EXPECT_NEAR(clocks, 3000 / (ticks_per_clock * times), 0.001 * clocks + 4) << ticks_per_clock;
  }
  EXPECT_EQ(generator_.snapshot().positions,
            (drivers::StepGenerator::Positions{18000, 18000, -18000, 18000}));
}

TEST_F(StepGeneratorOverrideTest, takes_the_override_at_once_at_rest_and_starts_nothing_on_hold) {
  generator_.set_slopes(1, 1);
  generator_.set_override(0);
  chip_.clock(4);
  EXPECT_EQ(generator_.scale(), 0);
  append(line({10, 0, 0, 0}));
  chip_.clock(1000);
  EXPECT_TRUE(generator_.held());
  EXPECT_TRUE(edges_.empty());
  generator_.set_slopes(1u << 24u, 1);
  generator_.set_override(one);
  run_until_idle();
  EXPECT_EQ(edges_.size(), 10);
}

TEST_F(StepGeneratorOverrideTest, loses_no_step_when_the_scale_wanders_during_guard_stalls) {
  use(drivers::GuardTimings::of(drivers::tmc2209, units::Hertz{50'000'000}));
  generator_.set_slopes(1u << 26u, 1u << 26u);
  append_motion();
  for (std::uint32_t i = 0; !generator_.idle(); ++i) {
    generator_.set_override(i * 40503u % (4 * one));
    chip_.clock(100);
  }
  EXPECT_THAT(generator_.snapshot().positions, ElementsAre(3500, -3500, 1734, 7));
}

}  // namespace
