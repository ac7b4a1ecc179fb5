// SPDX-License-Identifier: Apache-2.0
// Bounds of short programs; that of one with every kind of instruction is its measured time.
#include <gtest/gtest.h>

#include "sim/processor/encode.hpp"
#include "tests/timing/measured_program.hpp"
#include "tools/timing/analysis.hpp"

namespace timing {
namespace {

namespace encode = processor::encode;
TEST(Bound, is_the_measured_time_of_a_program_with_every_kind_of_instruction) {
  const MeasuredProgram measured = measured_program();
  EXPECT_EQ(sum_of_costs(measured.program, true_costs(), measured.steps), measured.clocks);
  EXPECT_EQ(bound_of(measured.program, true_costs()), measured.clocks);
}

TEST(Bound, needs_no_fact_that_the_code_shows) {
  MeasuredProgram measured = measured_program();
  Program& program = measured.program;
  program.markers.push_back({.address = MeasuredProgram::address(place::counted_loop), .most = 3});
  EXPECT_EQ(bound_of(program, true_costs()), measured.clocks) << "the code shows 5 rounds";
  program.memory_bytes = 0;
  EXPECT_EQ(bound_of(program, true_costs()), measured.clocks) << "the stack is memory";
}

TEST(Bound, takes_the_longest_way_and_the_declared_rounds) {
  Program program = with_choices();
  program.markers = {{.address = program.first + setup_bytes + 12, .most = 4}};
  // The division: 1 + 18; four rounds, each 1, the load from anywhere 3, the jump 2; out 3; back 3.
  EXPECT_EQ(bound_of(program, true_costs()), 19U + 4 * 6 + 3 + 3);
}

TEST(Bound, takes_an_unknown_address_for_memory_where_nothing_accesses_the_bus) {
  Program program = with_choices();
  program.markers = {{.address = program.first + setup_bytes + 12, .most = 4}};
  program.functions_on_bus.emplace();
  EXPECT_EQ(bound_of(program, true_costs()), 19U + 4 * 4 + 3 + 3) << "the load takes 1 clock";
  program.functions_on_bus = {program.first + setup_bytes};
  EXPECT_EQ(bound_of(program, true_costs()), 19U + 4 * 6 + 3 + 3);
}

TEST(Bound, a_loop_without_bound_is_a_problem_with_its_place) {
  Program program = with_choices();
  Analysis analysis(program, true_costs(), true);
  EXPECT_FALSE(analysis.bound(program.first + setup_bytes));
  ASSERT_EQ(analysis.problems().size(), 1U);
  EXPECT_EQ(analysis.problems().begin()->place, "0x80000010");
  EXPECT_EQ(analysis.problems().begin()->function, "choices");
}

TEST(Bound, functions_that_go_on_in_each_other_are_a_problem) {
  Program program = program_of({encode::nop(), encode::nop(), encode::jump_and_link(1, 8),
                                encode::jump_and_link_register(0, 8, 0),
                                encode::jump_and_link(0, 4), encode::jump_and_link(0, -4)});
  program.symbols[program.first + 16] = {.name = "one", .size = 4};
  program.symbols[program.first + 20] = {.name = "other", .size = 4};
  EXPECT_FALSE(bound_of(program, true_costs()));
}

TEST(Bound, a_call_of_what_lies_outside_the_code_is_a_problem) {
  const Program program = program_of(
      {encode::nop(), encode::nop(), encode::load_upper(10, 0x90000000),
       encode::jump_and_link_register(1, 10, 0), encode::jump_and_link_register(0, 8, 0)});
  EXPECT_FALSE(bound_of(program, true_costs()));
}

TEST(Bound, a_function_that_calls_itself_is_a_problem) {
  const Program program =
      program_of({encode::nop(), encode::nop(), encode::branch(0, 10, 0, 8),
                  encode::jump_and_link(1, -4), encode::jump_and_link_register(0, 1, 0)});
  Analysis analysis(program, true_costs(), true);
  EXPECT_FALSE(analysis.bound(program.first + setup_bytes));
  EXPECT_FALSE(analysis.problems().empty());
}

TEST(Bound, a_call_of_what_is_not_known_is_a_problem) {
  const Program program =
      program_of({encode::nop(), encode::nop(), encode::jump_and_link_register(1, 10, 0),
                  encode::jump_and_link_register(0, 8, 0)});
  EXPECT_FALSE(bound_of(program, true_costs()));
}

TEST(Bound, a_loop_with_two_entries_is_a_problem) {
  const Program program =
      program_of({encode::nop(), encode::nop(), encode::branch(0, 10, 0, 8),
                  encode::load(2, 11, 2, 0), encode::load(2, 12, 2, 0),
                  encode::branch(0, 12, 11, -8), encode::jump_and_link_register(0, 1, 0)});
  Analysis analysis(program, true_costs(), true);
  EXPECT_FALSE(analysis.bound(program.first + setup_bytes));
  ASSERT_EQ(analysis.problems().size(), 1U);
  EXPECT_EQ(analysis.problems().begin()->what, "a loop has several entries");
}

}  // namespace
}  // namespace timing
