// SPDX-License-Identifier: Apache-2.0
// The Verilated step generator against the reference model: the same pins in every clock of
// random runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "platform/bus.hpp"
#include "tests/drivers/step_generator_replay.hpp"
#include "tests/motion_reference/random_stimuli.hpp"

namespace {

namespace registers = ::registers::step_generator;
using motion_reference::Edge;
using motion_reference::StepGeneratorReference;

constexpr std::size_t segments_of_a_run = 500;

std::uint32_t setting(const char* name, std::uint32_t otherwise) {
  const char* asked = std::getenv(name);
  return asked ? static_cast<std::uint32_t>(std::strtoul(asked, nullptr, 10)) : otherwise;
}

// Runs of 500 segments; the slow variant of the test requests more.
std::uint32_t runs() { return setting("STEP_GENERATOR_RUNS", 16); }
std::uint32_t first_seed() { return setting("STEP_GENERATOR_FIRST_SEED", 0); }

void expect_same_edges(const std::vector<Edge>& actual, const std::vector<Edge>& expected) {
  const auto [at, wanted] = std::ranges::mismatch(actual, expected);
  if (at == actual.end() && wanted == expected.end()) return;
  const auto describe = [](auto edge, auto end) {
    if (edge == end) return std::string("no more edges");
    return "clock " + std::to_string(edge->clock) + ", step " + std::to_string(edge->pins.step) +
           ", direction " + std::to_string(edge->pins.direction);
  };
  FAIL() << "edge " << at - actual.begin() << ": " << describe(at, actual.end()) << "; expected "
         << describe(wanted, expected.end());
}

void expect_same_registers(const StepGeneratorReference& reference) {
  const auto& counters = reference.counters();
  EXPECT_EQ(platform::read<registers::SegmentsExecuted>().count, counters.segments);
  EXPECT_EQ(platform::read<registers::Underruns>().count, counters.underruns);
  EXPECT_EQ(platform::read<registers::Stalls>().clocks, counters.stalls);
  EXPECT_EQ(platform::read<registers::MaxLevel>().segments, counters.max_level);
  EXPECT_EQ(platform::read<registers::Scale>().scale, reference.scale() >> 16u);
  EXPECT_EQ(platform::read<registers::Status>().stopped, reference.stopped());
  EXPECT_EQ(platform::read<registers::Status>().positions_lost, reference.positions_lost());
  EXPECT_EQ(platform::read<registers::MotorEnable>().axes, reference.motors());
  EXPECT_EQ(platform::read<registers::Errors>().encode(), reference.errors());
  EXPECT_EQ(platform::read<registers::StopCause>().encode(), reference.stop_cause());
  EXPECT_EQ(platform::read<registers::StopTime>().clocks, reference.stop_moment().clock);
  EXPECT_EQ(platform::read<registers::SnapshotTime>().clocks, reference.snapshot().clock);
  for (std::size_t axis = 0; axis < motion_reference::axes; ++axis) {
    EXPECT_EQ(platform::read<registers::Position>(axis).steps, reference.positions()[axis]);
    EXPECT_EQ(platform::read<registers::AxisStalls>(axis).clocks, counters.axis_stalls[axis]);
    EXPECT_EQ(platform::read<registers::StopPosition>(axis).steps,
              reference.stop_moment().positions[axis]);
    EXPECT_EQ(platform::read<registers::SnapshotPosition>(axis).steps,
              reference.snapshot().positions[axis]);
  }
}

TEST(step_generator_reference, agrees_with_the_hardware_in_every_clock_of_random_runs) {
  std::uint64_t clocks = 0, segments = 0, edges = 0;
  const std::uint32_t end = first_seed() + runs();
  for (std::uint32_t seed = first_seed(); seed < end && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto run = motion_reference::random_run(seed, segments_of_a_run);
    tests::StepGeneratorReplay replay(run.stimuli);
    expect_same_edges(replay.run(run.clocks), run.edges);
    expect_same_registers(run.reference);
    clocks += run.clocks;
    segments += run.reference.counters().segments;
    edges += run.edges.size();
  }
  EXPECT_GT(segments, runs() * segments_of_a_run / 3);
  std::printf("%llu segments executed, %llu edges, %llu clocks\n",
              static_cast<unsigned long long>(segments), static_cast<unsigned long long>(edges),
              static_cast<unsigned long long>(clocks));
}

}  // namespace
