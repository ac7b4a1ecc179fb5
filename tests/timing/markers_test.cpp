// SPDX-License-Identifier: Apache-2.0
// Which declared bound counts for which loop; and images in which interrupts run code.
#include <gtest/gtest.h>

#include "tests/timing/short_program.hpp"
#include "tools/timing/flow.hpp"

namespace timing {
namespace {

namespace encode = processor::encode;
using encode::Word;

// while (a0 != 0) { a0 = *a0; a1 = a0[1]; while (a1 != 0) a1 = *a1; }
Program loop_in_a_loop() {
  return program_of({encode::nop(), encode::nop(), encode::branch(0, 10, 0, 28),
                     encode::load(2, 10, 10, 0), encode::load(2, 11, 10, 4),
                     encode::branch(0, 11, 0, 12), encode::load(2, 11, 11, 0),
                     encode::jump_and_link(0, -8), encode::jump_and_link(0, -24),
                     encode::jump_and_link_register(0, 1, 0)});
}

TEST(Markers, each_of_two_loops_needs_a_marker) {
  Program program = loop_in_a_loop();
  const Address outer = program.first + setup_bytes + 4, inner = outer + 12;
  const LoopMarker of_outer{.address = outer, .most = 4}, of_inner{.address = inner, .most = 2};
  const LoopMarker end_of_outer{.address = outer + 24, .most = 4, .is_end = 1};
  const LoopMarker end_of_inner{.address = inner + 8, .most = 2, .is_end = 1};
  program.markers = {of_outer, of_inner, end_of_outer, end_of_inner};
  // The outer loop: 1, two loads from anywhere and 1 for the address that is late, the inner loop,
  // back 2. The inner loop: 1 for the late value at first, 3 and 1 and 3 a round, out 3.
  const Clocks inner_clocks = 1 + 2 * (1 + 3 + 2) + 3;
  EXPECT_EQ(bound_of(program, true_costs()), 4 * (1 + 3 + 1 + 3 + inner_clocks + 2) + 3 + 3);
  program.markers = {of_outer, end_of_outer};
  EXPECT_FALSE(bound_of(program, true_costs()));
  program.markers = {of_inner, end_of_inner};
  EXPECT_FALSE(bound_of(program, true_costs()));
}

TEST(Markers, a_marker_at_the_start_of_a_loop_may_be_that_of_the_loop_around) {
  Program program = loop_in_a_loop();
  const Address inner = program.first + setup_bytes + 12, behind = inner + 12;
  const LoopMarker of_one{.address = inner, .most = 4};
  const LoopMarker of_inner{.address = inner, .most = 2};
  const LoopMarker end_behind_inner{.address = behind, .most = 2, .is_end = 1};
  program.markers = {of_one};
  EXPECT_FALSE(bound_of(program, true_costs()));
  program.markers = {of_inner, end_behind_inner};
  EXPECT_FALSE(bound_of(program, true_costs()));
  program.markers = {of_one, of_inner, end_behind_inner};
  EXPECT_TRUE(bound_of(program, true_costs()));
}

TEST(Markers, a_marker_whose_object_ends_in_the_loop_does_not_count) {
  Program program = with_choices();
  const Address load = program.first + setup_bytes + 12;
  program.markers = {{.address = load, .most = 4}};
  EXPECT_TRUE(bound_of(program, true_costs()));
  program.markers.push_back({.address = load + 4, .most = 4, .is_end = 1});
  EXPECT_FALSE(bound_of(program, true_costs()));
  program.markers.back().tag = 1;
  EXPECT_TRUE(bound_of(program, true_costs())) << "that of another object";
}

TEST(Markers, a_marker_that_a_round_may_miss_does_not_count) {
  // while (a1 != 0) { if (a0 != 0) a2 = 0; a1 = *a1; }
  Program program = program_of({encode::nop(), encode::nop(), encode::branch(0, 11, 0, 20),
                                encode::branch(0, 10, 0, 8), encode::add_immediate(12, 0, 0),
                                encode::load(2, 11, 11, 0), encode::jump_and_link(0, -16),
                                encode::jump_and_link_register(0, 1, 0)});
  program.markers = {{.address = program.first + 16, .most = 4}};
  EXPECT_FALSE(bound_of(program, true_costs()));
  program.markers = {{.address = program.first + 12, .most = 4}};
  EXPECT_TRUE(bound_of(program, true_costs()));
}

TEST(Markers, a_marker_at_the_start_does_not_count_where_two_ways_lead_back) {
  // do a1 = *a1; while (a1 != 0 || a0 != 0);
  Program program = program_of({encode::nop(), encode::nop(), encode::load(2, 11, 11, 0),
                                encode::branch(1, 11, 0, -4), encode::branch(1, 10, 0, -8),
                                encode::jump_and_link_register(0, 1, 0)});
  program.markers = {{.address = program.first + setup_bytes, .most = 4}};
  EXPECT_FALSE(bound_of(program, true_costs()));
}

TEST(Markers, copies_of_a_marker_on_different_ways_add_up) {
  // while (a1 != 0) { if (a0 != 0) a1 = *a1; else a1 = a1[1]; }
  Program program = program_of(
      {encode::nop(), encode::nop(), encode::branch(0, 11, 0, 24), encode::branch(0, 10, 0, 12),
       encode::load(2, 11, 11, 0), encode::jump_and_link(0, -12), encode::load(2, 11, 11, 4),
       encode::jump_and_link(0, -20), encode::jump_and_link_register(0, 1, 0)});
  program.markers = {{.address = program.first + 16, .most = 4},
                     {.address = program.first + 24, .most = 4}};
  // Eight rounds: 1, to the other load 3, that 3, back 2; out 3; back 3.
  EXPECT_EQ(bound_of(program, true_costs()), 8U * (1 + 3 + 3 + 2) + 3 + 3);
  program.markers.pop_back();
  EXPECT_FALSE(bound_of(program, true_costs()));
}

TEST(Interrupts, that_run_code_are_found) {
  constexpr Word set = 2, clear = 3, write = 1, immediate = 4, status = 0x300, mie = 8;
  const auto enables = [](Word word) {
    return place_that_enables_interrupts(program_of({encode::nop(), word}), true).has_value();
  };
  EXPECT_TRUE(enables(encode::csr(set, 0, status, 5)));
  EXPECT_TRUE(enables(encode::csr(write, 0, status, 5)));
  EXPECT_TRUE(enables(encode::csr(set | immediate, 0, status, mie)));
  EXPECT_TRUE(enables(encode::csr(write | immediate, 0, status, mie)));
  EXPECT_TRUE(enables(encode::trap_return()));
  EXPECT_FALSE(enables(encode::csr(clear | immediate, 0, status, mie)));
  EXPECT_FALSE(enables(encode::csr(set | immediate, 0, status, 1)));
  EXPECT_FALSE(enables(encode::csr(write, 0, 0x304, 5)));
}

}  // namespace
}  // namespace timing
