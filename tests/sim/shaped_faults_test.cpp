// SPDX-License-Identifier: Apache-2.0
// Faults of a printer with input shaping or linear advance are found.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "shaped_faults.hpp"
#include "shaped_program.hpp"

namespace tests {

TEST(ShapedFaults, are_found_where_shaping_does_not_explain_them) {
  struct Count {
    int made{}, beyond{}, found{}, found_beyond{};
  };
  std::array<Count, static_cast<std::size_t>(Fault::count)> counts{};

  for (std::uint32_t seed = 0; seed < 1100; ++seed) {
    const auto kind = static_cast<Fault>(seed % counts.size());
    const double clock_hz = seed / counts.size() % 2 == 0 ? 4e6 : 50e6;
    const RandomProgram program(seed, clock_hz, true);
    std::mt19937 random(seed);
    const std::vector<Command> made = faulty(kind, program.commands(), program.limits(), random);
    if (made.empty()) continue;
    ShapedPrinter printer(clock_hz, program.given(), program.limits(), program.buffered());
    const Axes tolerance = tolerance_of(program.commands(), program.given(), printer.slot_s());
    ShapingChoice real = program.given();
    if (kind == Fault::slow_shaper) {
      for (ShaperChoice* shaper : {&real.x, &real.y}) *shaper = {"zvd", 4, 0.1};
      printer.be_shaped_by(real);
    }
    if (kind == Fault::long_advance) {
      real.advance_s = 1;
      printer.be_shaped_by(real);
    }
    bool beyond = false;
    if (kind == Fault::forth_and_back) {
      const std::size_t axis = random() % 4;
      const auto steps = static_cast<std::int64_t>(1 + random() % 200);
      printer.twitch(
          {axis, random() % 2 == 0 ? steps : -steps, 0, static_cast<double>(random() % 101) / 100});
      beyond = static_cast<double>(steps) > 2 * tolerance[axis] + 2;
    }
    printer.run(made);
    beyond = beyond || !passes(program.commands(), printer, tolerance);
    const bool found = !complaint_of(printer, program.commands()).empty();
    Count& count = counts[static_cast<std::size_t>(kind)];
    ++count.made;
    count.found += found;
    count.beyond += beyond;
    count.found_beyond += found && beyond;
    if (beyond && !found) fmt::print("{} not found: seed {}\n", name_of(kind), seed);
  }
  for (std::size_t i = 0; i < counts.size(); ++i) {
    fmt::print("{}: {} made, {} found; {} beyond the tolerance, {} of them found\n",
               name_of(static_cast<Fault>(i)), counts[i].made, counts[i].found, counts[i].beyond,
               counts[i].found_beyond);
    EXPECT_EQ(counts[i].found_beyond, counts[i].beyond);
    EXPECT_GT(counts[i].found_beyond, 0);
  }
}

}  // namespace tests
