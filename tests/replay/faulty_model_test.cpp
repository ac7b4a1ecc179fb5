// SPDX-License-Identifier: Apache-2.0
// A fault in the simulation is found by the netlist, and named. This program is linked with a
// source of sim/ into which one was put (EXPECTED_DIFFERENCE: a part of the name). REPLAYED_EDGES
// is `all` for a fault in a leap: by default both sides would leap wrongly.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/replay/netlist_replay.hpp"
#include "tests/replay/recorded_run.hpp"

namespace {

TEST(FaultyModel, is_found_by_the_netlist) {
  constexpr sim::Clock length = 200'000;
  const replay::Replay replay =
      replay::make_netlist_replay(tests::recorded_clock_hz, false, sim::Edges::REPLAYED_EDGES);
  std::vector<std::string> found;
  for (const replay::Interval& interval : tests::recorded_run(6 * length, length)) {
    if (const auto difference = replay(interval)) found.push_back(difference->what);
  }
  EXPECT_THAT(found, testing::Contains(testing::HasSubstr(EXPECTED_DIFFERENCE)));
}

}  // namespace
