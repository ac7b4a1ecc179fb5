// SPDX-License-Identifier: Apache-2.0
// The model that takes the processor's place in simulations does in each clock what the netlist
// does, whatever the program, with interrupts requested and withdrawn in any clock.
#include <gtest/gtest.h>

#include "sim/processor/times.hpp"
#include "sim/processor/timing_table.hpp"
#include "tests/processor/chip.hpp"
#include "tests/processor/model_lockstep.hpp"
#include "tests/processor/program.hpp"
#include "tests/processor/random_program.hpp"
#include "tests/processor/timed_program.hpp"
#include "tests/processor/timing_kinds.hpp"

namespace processor {
namespace {

void expect_same(const std::vector<std::uint8_t>& image, const ModelLockstepSettings& settings,
                 ModelLockstep& sum) {
  const ModelLockstep run = run_model_lockstep(image, settings);
  ASSERT_EQ(run.difference, "") << "seed " << settings.seed << ", bus " << settings.bus_wait
                                << ", ahead " << settings.longest_lead;
  sum.instructions += run.instructions;
  sum.traps += run.traps;
  sum.accesses += run.accesses;
  sum.sleeping_clocks += run.sleeping_clocks;
  for (const auto& [operation, count] : run.interrupted) sum.interrupted[operation] += count;
  for (const auto& [operation, count] : run.behind) sum.behind[operation] += count;
}

TEST(ModelLockstep, has_the_times_of_the_table) {
  const TimingTable table;
  for (const char* row :
       {"arithmetic and logic", "bit manipulation", "multiplication", "load from memory",
        "store to memory", "CSR instruction", "wfi", "branch predicted not taken, not taken"}) {
    EXPECT_EQ(table.at(row), 1U) << row;
  }
  EXPECT_EQ(table.at("store to a peripheral"), table.at("load from a peripheral"));
  EXPECT_EQ(table.at("branch predicted taken, taken"), 1U + times::predicted_taken);
  EXPECT_EQ(table.at("branch predicted taken, not taken"), 1U + times::mispredicted);
  EXPECT_EQ(table.at("branch predicted not taken, taken"), 1U + times::mispredicted);
  EXPECT_EQ(table.at("jump"), 1U + times::jump);
  EXPECT_EQ(table.at("jump to a register"), 1U + times::jump_register);
  EXPECT_EQ(table.at("fence.i"), 1U + times::fence_i);
  EXPECT_EQ(table.at("mret"), 1U + times::trap_return);
  EXPECT_EQ(table.at("exception"), 1U + times::trap);
  EXPECT_EQ(table.at("refused access"), table.at("load from a peripheral") + times::trap);
  EXPECT_EQ(table.at("division"), 1U + times::division);
  EXPECT_EQ(table.at("load-use hazard"), times::late_result_used);
  // The clock of the request, that in which it is taken, the first one of the handler.
  EXPECT_EQ(table.at("interrupt"), 1U + times::interrupt_seen + times::trap + 1U);
  EXPECT_EQ(table.at("wake-up from wfi"), 1U + times::interrupt_seen);
  EXPECT_EQ(table.at("interrupt requested with mret") - table.at("interrupt"),
            times::interrupt_after_return - 1U);
}

TEST(ModelLockstep, instructions_of_all_rows_of_the_table_with_interrupts_in_any_clock) {
  ModelLockstep sum;
  for (std::uint32_t seed = 1; seed <= 60 && !HasFatalFailure(); ++seed) {
    expect_same(timed_program(seed),
                {.clocks = 50'000,
                 .bus_wait = 1 + seed % 4,
                 .seed = seed,
                 .longest_pause = seed % 2 == 0 ? 12U : 60U,
                 .longest_lead = seed % 3 == 0 ? 1U : 50U},
                sum);
  }
  EXPECT_GT(sum.traps, 20'000U);
  EXPECT_GT(sum.accesses, 20'000U);
  EXPECT_GT(sum.sleeping_clocks, 5'000U);
  // An interrupt came instead of each instruction, and after each.
  for (const Kind& kind : kinds_of_instructions()) {
    const std::string row = kind.row;
    const Operation operation = decode(kind.word, Chip::memory_base, Chip::has_zbb).operation;
    if (row == "exception") continue;
    EXPECT_GT(sum.interrupted[operation], 20U) << row << ", " << std::hex << kind.word;
    if (row != "refused access") {
      EXPECT_GT(sum.behind[operation], 4U) << row << ", " << std::hex << kind.word;
    }
  }
  EXPECT_GT(sum.behind[Operation::wait_for_interrupt], 500U);
  EXPECT_GT(sum.behind[Operation::trap_return], 500U);
}

TEST(ModelLockstep, random_programs_with_wild_words) {
  ModelLockstep sum;
  for (std::uint32_t seed = 1; seed <= 60 && !HasFatalFailure(); ++seed) {
    const auto image = random_program(
        seed, {.length = 2000, .wild_per_mille = 100, .interrupts = true, .zbb = Chip::has_zbb});
    expect_same(image,
                {.clocks = 12'000,
                 .bus_wait = 1 + seed % 3,
                 .seed = seed % 2 == 0 ? seed : 0,
                 .longest_lead = 1 + 30 * (seed % 3)},
                sum);
  }
  EXPECT_GT(sum.instructions, 200'000U);
}

TEST(ModelLockstep, directed_programs) {
  ModelLockstep sum;
  for (const char* name : {"arithmetic", "compressed", "memory", "traps", "registers", "interrupts",
                           "machine_mode", "busy"}) {
    if (HasFatalFailure()) return;
    expect_same(read_program(name).image, {.clocks = 40'000, .longest_lead = 200}, sum);
  }
  if (Chip::has_zbb) {
    expect_same(read_program("bit_manipulation").image, {.clocks = 40'000, .longest_lead = 200},
                sum);
  }
  EXPECT_GT(sum.instructions, 10'000U);
}

}  // namespace
}  // namespace processor
