// SPDX-License-Identifier: Apache-2.0
// The contact of an end stop, clock by clock.
#include "sim/devices/end_stop.hpp"

#include <gmock/gmock.h>

#include "sim/simulation/simulation.hpp"
#include "tests/sim/fake_chip.hpp"

namespace {

using devices::EndStopFault;

constexpr sim::ClockRate rate(1'000'000);
constexpr sim::Clock millisecond = 1000;

class EndStopTest : public testing::Test {
 protected:
  // The axis comes to this position, and what the contact does then is watched for so long.
  void step_to(devices::EndStop& end_stop, std::int64_t position) {
    edges.clear();
    shortest = sim::never;
    const sim::Clock begin = chip.now();
    bool closed = end_stop.closed();
    end_stop.stepped({.clock = begin, .axis = 0, .direction = 1, .position = position});
    at_once = end_stop.closed() != closed;
    for (sim::Clock clock = begin; clock < begin + 20 * millisecond; ++clock) {
      simulation.run_until(clock + 1);
      if (end_stop.closed() == closed) continue;
      closed = end_stop.closed();
      if (!edges.empty()) shortest = std::min(shortest, clock - edges.back());
      edges.push_back(clock);
    }
    lasted = edges.empty() ? 0 : edges.back() - begin;
  }

  tests::FakeChip chip;
  sim::Simulation simulation{chip, rate};
  std::vector<sim::Clock> edges;
  sim::Clock shortest{}, lasted{};
  bool at_once{};
};

TEST_F(EndStopTest, switches_once_where_it_is_good) {
  devices::EndStop end_stop(0, 3, rate, chip.inputs(), 5);
  simulation.attach(end_stop, {});
  step_to(end_stop, 0);
  EXPECT_EQ(edges.size(), 1U);
  EXPECT_EQ(chip.inputs().end_stops, 1U << 3);
  step_to(end_stop, 1);
  EXPECT_EQ(edges.size(), 1U);
  EXPECT_EQ(chip.inputs().end_stops, 0);
}

TEST_F(EndStopTest, bounces_for_milliseconds_and_then_rests_where_it_should) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    devices::EndStop end_stop(0, 3, rate, chip.inputs(), 5, EndStopFault::bounces, seed);
    simulation.attach(end_stop, {});
    EXPECT_FALSE(end_stop.closed());
    step_to(end_stop, 0);
    EXPECT_TRUE(at_once);
    EXPECT_TRUE(end_stop.closed());
    EXPECT_GE(edges.size(), 3U);
    EXPECT_LE(lasted, 5 * millisecond);
    EXPECT_GE(lasted, millisecond / 2);
    step_to(end_stop, -1);
    EXPECT_EQ(edges.size(), 0U);
    step_to(end_stop, 1);
    EXPECT_TRUE(at_once);
    EXPECT_FALSE(end_stop.closed());
    EXPECT_GE(edges.size(), 1U);
    EXPECT_LE(lasted, 3 * millisecond);
  }
}

}  // namespace
