// SPDX-License-Identifier: Apache-2.0
// Facts about events in short programs: what they limit, and where markers do not count.
#include <gtest/gtest.h>

#include "tests/timing/short_program.hpp"

namespace timing {
namespace {

namespace encode = processor::encode;
using encode::Word;

constexpr Clocks division = 18, not_taken = 1, taken = 3, load = 3, jump = 2, back = 3, late = 1;
constexpr std::uint32_t event = 7;

EventMarker begin(Address address, std::uint32_t most) {
  return {.address = address, .event = event, .most = most, .kind = EventMarker::begin};
}
EventMarker end(Address address, std::uint32_t most) {
  return {.address = address, .event = event, .most = most, .kind = EventMarker::end};
}
EventMarker happens(Address address) {
  return {.address = address, .event = event, .kind = EventMarker::event_happens};
}

// if (a0 != 0) a division; if (a1 != 0) a division.
Program two_choices() {
  return program_of({encode::nop(), encode::nop(), encode::branch(0, 10, 0, 8),
                     encode::operation(4, 1, 12, 11, 10), encode::branch(0, 11, 0, 8),
                     encode::operation(4, 1, 12, 11, 10), encode::jump_and_link_register(0, 1, 0)});
}

TEST(Events, of_which_one_excludes_the_other) {
  Program program = two_choices();
  const Address start = program.first + setup_bytes;
  EXPECT_EQ(bound_of(program, true_costs()), 2 * (not_taken + division) + back);
  program.event_markers = {begin(start, 1), happens(start + 4), happens(start + 12),
                           end(start + 16, 1)};
  EXPECT_EQ(bound_of(program, true_costs()), not_taken + division + taken + back);
  program.event_markers[2].event = event + 1;
  EXPECT_EQ(bound_of(program, true_costs()), 2 * (not_taken + division) + back) << "another event";
}

TEST(Events, behind_the_end_of_their_run_are_not_limited) {
  Program program = two_choices();
  const Address start = program.first + setup_bytes;
  program.event_markers = {begin(start, 1), happens(start + 4), end(start + 8, 1),
                           happens(start + 12)};
  EXPECT_EQ(bound_of(program, true_costs()), 2 * (not_taken + division) + back);
  program.event_markers = {happens(start + 4), begin(start + 8, 1), happens(start + 12)};
  EXPECT_EQ(bound_of(program, true_costs()), 2 * (not_taken + division) + back)
      << "before its beginning";
}

TEST(Events, that_no_path_avoids_contradict_a_bound_of_0) {
  Program program = program_of(
      {encode::nop(), encode::nop(), encode::nop(), encode::jump_and_link_register(0, 1, 0)});
  const Address start = program.first + setup_bytes;
  program.event_markers = {begin(start, 1), happens(start + 4)};
  EXPECT_EQ(bound_of(program, true_costs()), 1 + back);
  program.event_markers = {begin(start, 0), happens(start + 4)};
  Analysis analysis(program, true_costs(), true);
  EXPECT_FALSE(analysis.bound(start));
  ASSERT_EQ(analysis.problems().size(), 1U);
  EXPECT_EQ(analysis.problems().begin()->what, "no path keeps to the bounds of its events");
}

// while (a0 != 0) { a0 = *a0; a1 = a0[1]; while (a1 != 0) a1 = *a1; } with 4 and 2 rounds.
Program loop_in_a_loop() {
  Program program = program_of({encode::nop(), encode::nop(), encode::branch(0, 10, 0, 28),
                                encode::load(2, 10, 10, 0), encode::load(2, 11, 10, 4),
                                encode::branch(0, 11, 0, 12), encode::load(2, 11, 11, 0),
                                encode::jump_and_link(0, -8), encode::jump_and_link(0, -24),
                                encode::jump_and_link_register(0, 1, 0)});
  const Address start = program.first + setup_bytes;
  program.markers = {{.address = start + 4, .most = 4},
                     {.address = start + 16, .most = 2},
                     {.address = start + 28, .most = 4, .is_end = 1},
                     {.address = start + 24, .most = 2, .is_end = 1}};
  return program;
}

Clocks of_rounds(Clocks outer, Clocks inner) {
  return outer * (not_taken + load + late + load + late + taken + jump) +
         inner * (not_taken + load + jump) + taken + back;
}

TEST(Events, in_all_rounds_of_an_outer_loop_together_are_limited) {
  Program program = loop_in_a_loop();
  const Address start = program.first + setup_bytes;
  EXPECT_EQ(bound_of(program, true_costs()), of_rounds(4, 8));
  // The run begins at the start of the outer loop too, but not in each round.
  program.event_markers = {begin(start, 3), happens(start + 16), end(start + 28, 3)};
  EXPECT_EQ(bound_of(program, true_costs()), of_rounds(4, 3));
  program.event_markers = {begin(start + 4, 1), happens(start + 16), end(start + 24, 1)};
  EXPECT_EQ(bound_of(program, true_costs()), of_rounds(4, 4)) << "in each outer round";
}

TEST(Events, at_the_start_of_a_loop_count_where_it_begins_only) {
  Program program = loop_in_a_loop();
  const Address start = program.first + setup_bytes;
  // What jumps back there may come behind the marker.
  program.event_markers = {begin(start, 3), happens(start + 12)};
  EXPECT_EQ(bound_of(program, true_costs()), of_rounds(3, 6));
}

TEST(Events, at_the_start_of_a_function_do_not_count) {
  Program program = two_choices();
  const Address start = program.first + setup_bytes;
  program.event_markers = {begin(start, 0), happens(start)};
  EXPECT_EQ(bound_of(program, true_costs()), 2 * (not_taken + division) + back);
}

TEST(Events, behind_a_call_that_does_not_return_do_not_count) {
  // if (a0 == 0) goto there; halt(); there: two nops; halt: a trap.
  Program program = program_of({encode::nop(), encode::nop(), encode::branch(0, 10, 0, 8),
                                encode::jump_and_link(1, 12), encode::nop(),
                                encode::jump_and_link_register(0, 1, 0), encode::breakpoint()});
  const Address start = program.first + setup_bytes;
  program.symbols[start + 16] = {.name = "halt", .size = 4};
  program.event_markers = {begin(start, 0), happens(start + 8)};
  EXPECT_EQ(bound_of(program, true_costs()), taken + 1 + back);
}

// while (a1 != 0) f(); in f: if (a0 != 0) a division.
Program calls_in_a_loop() {
  Program program = program_of(
      {encode::nop(), encode::nop(), encode::branch(0, 11, 0, 12), encode::jump_and_link(1, 12),
       encode::jump_and_link(0, -8), encode::environment_call(), encode::branch(0, 10, 0, 8),
       encode::operation(4, 1, 12, 11, 10), encode::jump_and_link_register(0, 1, 0)});
  const Address start = program.first + setup_bytes;
  program.symbols[start] = {.name = "caller", .size = 16};
  program.symbols[start + 16] = {.name = "f", .size = 12};
  program.markers = {{.address = start + 4, .most = 4}};
  return program;
}

TEST(Events, in_called_functions_are_limited) {
  Program program = calls_in_a_loop();
  const Address start = program.first + setup_bytes;
  const auto without = bound_of(program, true_costs());
  ASSERT_TRUE(without);
  program.event_markers = {begin(start, 1), happens(start + 20), end(start + 12, 1)};
  EXPECT_EQ(bound_of(program, true_costs()), *without - 3 * (not_taken + division - taken));
  // A run of f itself limits nothing in a second call.
  program.event_markers = {begin(start + 16, 1), happens(start + 20), end(start + 24, 1)};
  EXPECT_EQ(bound_of(program, true_costs()), *without);
  // It ends before the calls.
  program.event_markers = {begin(start, 1), end(start + 4, 1), happens(start + 20)};
  EXPECT_EQ(bound_of(program, true_costs()), *without);
}

// A loop without an end but a trap: while (true) { if (a0 != 0) a division; if (a1 == 0) trap; }
Program endless() {
  return program_of({encode::nop(), encode::nop(), encode::nop(), encode::branch(0, 10, 0, 8),
                     encode::operation(4, 1, 12, 11, 10), encode::branch(0, 11, 0, 8),
                     encode::jump_and_link(0, -12), encode::breakpoint()});
}

TEST(Round, of_a_loop_is_its_longest_way_from_start_to_start) {
  const Program program = endless();
  const Address start = program.first + setup_bytes;
  Analysis analysis(program, true_costs(), true);
  EXPECT_FALSE(analysis.bound(start)) << "nothing bounds the rounds";
  EXPECT_EQ(analysis.round(start), not_taken + division + not_taken + jump);
  EXPECT_EQ(analysis.round_start(start), start + 4);
}

TEST(Round, in_which_a_fact_of_all_rounds_or_of_each_holds) {
  Program program = endless();
  const Address start = program.first + setup_bytes;
  for (const Address begins : {start, start + 4}) {
    program.event_markers = {begin(begins, 0), happens(start + 8)};
    Analysis analysis(program, true_costs(), true);
    EXPECT_EQ(analysis.round(start), taken + not_taken + jump) << begins;
  }
}

TEST(Span, is_the_longest_way_from_one_place_to_another) {
  const Program program = endless();
  const Address start = program.first + setup_bytes;
  Analysis analysis(program, true_costs(), true);
  // From the choice of the division to the jump back.
  EXPECT_EQ(analysis.span(start, {start + 4}, {start + 16}), not_taken + division + not_taken);
  EXPECT_EQ(analysis.span(start, {start + 8}, {start + 12}), division);
  EXPECT_EQ(analysis.span(start, {start + 4, start + 8}, {start + 12}), not_taken + division);
  EXPECT_EQ(analysis.span(start, {start + 8}, {start + 4}), division + not_taken + jump);
  EXPECT_FALSE(analysis.span(start, {start + 8}, {start})) << "it never ends";
}

TEST(Round, of_a_function_without_a_loop_is_a_problem) {
  const Program program = two_choices();
  Analysis analysis(program, true_costs(), true);
  EXPECT_FALSE(analysis.round(program.first + setup_bytes));
  EXPECT_EQ(analysis.problems().size(), 1U);
}

TEST(Events, an_event_more_costs_what_the_way_to_it_costs) {
  for (std::uint32_t most = 0; most < 4; ++most) {
    Program program = calls_in_a_loop();
    const Address start = program.first + setup_bytes;
    program.event_markers = {begin(start, most), happens(start + 20)};
    const auto less = bound_of(program, true_costs());
    program.event_markers[0].most = most + 1;
    const auto more = bound_of(program, true_costs());
    ASSERT_TRUE(less && more);
    EXPECT_EQ(*more - *less, not_taken + division - taken) << most;
  }
}

}  // namespace
}  // namespace timing
