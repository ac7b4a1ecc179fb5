// SPDX-License-Identifier: Apache-2.0
// A program with every kind of instruction: its bound is the time that the processor model takes.
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "sim/processor/encode.hpp"
#include "tests/timing/short_program.hpp"
#include "tests/timing/trace.hpp"
#include "tools/timing/analysis.hpp"

namespace timing {
namespace {

namespace encode = processor::encode;
using encode::Word;

constexpr Word counter = 6, bus = 13;

// The place of the stack first; behind it the function that is bounded.
std::vector<Word> every_kind() {
  return {encode::add_upper_to_pc(2, 0),  // setup: the stack is somewhere in the memory
          encode::add_immediate(2, 2, 1024),
          encode::add_immediate(counter, 0, 5),
          encode::add_immediate(counter, counter, -1),  // the loop
          encode::load(2, 10, 2, 0),
          encode::add_immediate(10, 10, 1),
          encode::operation(0, 1, 11, 10, 10),
          encode::add_immediate(11, 11, 1),
          encode::operation(4, 1, 12, 11, 10),
          encode::load_upper(bus, 0xF0000000),
          encode::load(2, 14, bus, 0),
          encode::store(2, 14, bus, 4),
          encode::store(2, 14, 2, 4),
          encode::leading_zeros(15, 10),
          encode::add_immediate(15, 15, 1),
          encode::branch(1, counter, 0, -48),  // predicted to be taken
          encode::csr(2, 16, 0x340, 0),
          encode::fence_i(),
          encode::branch(0, 0, 0, 8),
          encode::nop(),  // taken, not predicted
          encode::branch(1, 0, 0, 8),
          encode::jump_and_link(0, 4),
          encode::jump_and_link_register(0, 1, 0)};
}

struct Tried {
  Program program;
  std::vector<Step> steps;
  Clocks clocks{};  // of the function
};

Tried tried() {
  Tried result{.program = program_of(every_kind()), .steps = {}};
  // Returns to 0.
  const auto steps = trace(result.program, 0, 2000, 7);
  for (const Step& step : steps) {
    if (step.address >= result.program.first + setup_bytes || step.address == 0) {
      result.steps.push_back(step);
    }
  }
  result.program.symbols[result.program.first + setup_bytes] = {.name = "function", .size = 4};
  result.clocks = result.steps.back().begins - result.steps.front().begins;
  return result;
}

TEST(Bound, is_the_measured_time_of_a_program_with_one_path) {
  const Tried program = tried();
  ASSERT_EQ(program.steps.back().address, 0U);
  EXPECT_EQ(sum_of_costs(program.program, true_costs(), program.steps), program.clocks);
  EXPECT_EQ(bound_of(program.program, true_costs()), program.clocks);
}

TEST(Bound, a_wrong_cost_is_found) {
  const Tried program = tried();
  const std::vector<std::pair<const char*, unsigned Costs::*>> rows{
      {"simple", &Costs::simple},
      {"multiplication", &Costs::multiplication},
      {"bit manipulation", &Costs::bit_manipulation},
      {"division", &Costs::division},
      {"load", &Costs::load},
      {"store", &Costs::store},
      {"bus load", &Costs::bus_load},
      {"bus store", &Costs::bus_store},
      {"not taken", &Costs::not_taken},
      {"taken", &Costs::taken},
      {"predicted, not taken", &Costs::predicted_not_taken},
      {"predicted, taken", &Costs::predicted_taken},
      {"jump", &Costs::jump},
      {"jump to a register", &Costs::jump_register},
      {"fence.i", &Costs::fence_i},
      {"CSR", &Costs::csr},
      {"late result", &Costs::hazard}};
  for (const auto& [name, row] : rows) {
    for (const int fault : {-1, 1}) {
      Costs costs = true_costs();
      costs.*row = static_cast<unsigned>(static_cast<int>(costs.*row) + fault);
      EXPECT_NE(sum_of_costs(program.program, costs, program.steps), program.clocks)
          << name << " " << fault;
      EXPECT_NE(bound_of(program.program, costs), program.clocks) << name << " " << fault;
    }
  }
}

TEST(Bound, a_wrong_fact_is_found) {
  Tried program = tried();
  const Address loop = program.program.first + setup_bytes + 4;
  Program changed = program.program;
  changed.markers = {{.address = loop, .most = 3}};
  EXPECT_EQ(bound_of(changed, true_costs()), program.clocks) << "the code shows 5 rounds";
  changed = program.program;
  changed.memory_start = 0xF000'0000;  // the bus taken for memory
  EXPECT_LT(*bound_of(changed, true_costs()), program.clocks);
  changed = program.program;
  changed.memory_bytes = 0;
  EXPECT_EQ(bound_of(changed, true_costs()), program.clocks) << "the stack is memory";
}

TEST(Bound, takes_the_longest_way_and_the_declared_rounds) {
  Program program = with_choices();
  program.markers = {{.address = program.first + setup_bytes + 12, .most = 4}};
  // The division: 1 + 18; four rounds, each 1, the load from anywhere 3, the jump 2; out 3; back 3.
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
