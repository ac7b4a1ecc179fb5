// SPDX-License-Identifier: Apache-2.0
// Random programs do on the chip what they do on the instruction-set model.
#include <gtest/gtest.h>

#include "tests/processor/chip.hpp"
#include "tests/processor/lockstep.hpp"
#include "tests/processor/random_program.hpp"

namespace processor {
namespace {

void run_all(unsigned seeds, unsigned first_seed, RandomProgramSettings settings) {
  settings.zbb = Chip::has_zbb;
  LockstepResult sum;
  for (unsigned seed = first_seed; seed < first_seed + seeds; ++seed) {
    const auto result = run_lockstep(random_program(seed, settings),
                                     {.tohost_address = random_program_tohost,
                                      .bus_wait = 1 + seed % 3,
                                      .interrupt_seed = settings.interrupts ? seed : 0});
    ASSERT_EQ(result.difference, "") << "seed " << seed;
    ASSERT_EQ(result.tohost, 1u) << "seed " << seed << " did not end";
    sum.instructions += result.instructions;
    sum.traps += result.traps;
    sum.interrupts += result.interrupts;
  }
  // The programs must have exercised enough.
  EXPECT_GT(sum.instructions, seeds * settings.length / 2);
  EXPECT_GT(sum.traps, seeds);
  if (settings.interrupts) {
    EXPECT_GT(sum.interrupts, 10 * seeds);
  }
  testing::Test::RecordProperty("instructions", static_cast<int>(sum.instructions));
  testing::Test::RecordProperty("interrupts", static_cast<int>(sum.interrupts));
}

TEST(RandomPrograms, do_the_same_on_the_model_without_interrupts) {
  run_all(100, 1, {.length = 2000, .interrupts = false});
}

TEST(RandomPrograms, do_the_same_on_the_model_with_interrupts) {
  run_all(100, 1000, {.length = 2000, .interrupts = true});
}

TEST(RandomPrograms, do_the_same_on_the_model_when_every_second_word_is_wild) {
  run_all(20, 2000, {.length = 2000, .wild_per_mille = 500, .interrupts = false});
}

}  // namespace
}  // namespace processor
