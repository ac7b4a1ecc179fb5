// SPDX-License-Identifier: Apache-2.0
// The directed programs run to their end, doing at each instruction what the model does.
#include <gtest/gtest.h>

#include "tests/processor/chip.hpp"
#include "tests/processor/lockstep.hpp"
#include "tests/processor/program.hpp"

namespace processor {
namespace {

class Programs : public testing::TestWithParam<const char*> {};

TEST_P(Programs, pass_and_do_the_same_on_the_model) {
  const Program program = read_program(GetParam());
  const auto result = run_lockstep(program.image, {.tohost_address = program.symbols.at("tohost"),
                                                   .wake_word = 0x51ee9,
                                                   .wake_request = 1u << 20});
  EXPECT_EQ(result.difference, "");
  // Otherwise the number of the first check that failed.
  EXPECT_EQ(result.tohost, 1u) << "check " << (result.tohost >> 1);
}

INSTANTIATE_TEST_SUITE_P(all, Programs,
                         testing::Values("arithmetic", "compressed", "memory", "traps", "registers",
                                         "interrupts", "machine_mode", "pass"),
                         [](const auto& parameter) { return parameter.param; });

TEST(Programs, find_bit_manipulation_only_where_it_is) {
  const Program program = read_program("bit_manipulation");
  const auto result = run_lockstep(program.image, {.tohost_address = program.symbols.at("tohost")});
  EXPECT_EQ(result.difference, "");
  constexpr std::uint32_t unexpected_trap = 0x7FF;
  EXPECT_EQ(result.tohost, Chip::has_zbb ? 1u : unexpected_trap)
      << "check " << (result.tohost >> 1);
}

TEST(Programs, fail_with_their_status) {
  const Program program = read_program("fail");
  const auto result = run_lockstep(program.image, {.tohost_address = program.symbols.at("tohost")});
  EXPECT_EQ(result.difference, "");
  EXPECT_EQ(result.tohost, 7u);
}

}  // namespace
}  // namespace processor
