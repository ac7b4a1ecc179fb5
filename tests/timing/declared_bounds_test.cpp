// SPDX-License-Identifier: Apache-2.0
// What the firmware declares for the analysis is checked on a host: one too many ends the program.
#include <gtest/gtest.h>

#include <string>

#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"
#include "units/text.hpp"

namespace units {
namespace {

void go_round(unsigned rounds) {
  LoopBound<3> bound;
  for (unsigned i = 0; i < rounds; ++i) bound.next();
}

TEST(DeclaredBounds, of_rounds_end_the_program_where_there_are_more) {
  go_round(3);
  EXPECT_DEATH(go_round(4), "");
}

void happen(unsigned outer, unsigned inner) {
  EventBound<Event::byte_taken, 5> bound;
  for (unsigned i = 0; i < outer; ++i) {
    EventBound<Event::byte_taken, 3> of_each;
    for (unsigned j = 0; j < inner; ++j) happens<Event::byte_taken>(j);
    happens<Event::byte_sent>();
  }
}

TEST(DeclaredBounds, of_events_end_the_program_where_there_are_more) {
  happens<Event::byte_taken>();  // before it
  happen(1, 3);
  happen(5, 1);
  EXPECT_DEATH(happen(1, 4), "") << "in one round";
  EXPECT_DEATH(happen(2, 3), "") << "in both";
  happen(1, 3);
}

TEST(Text, is_searched_as_by_the_library) {
  for (const std::string text : {"", "a", "N12", "xyzN", "//action:pause", "ab;cd;"}) {
    for (const std::string other : {"", "a", "Nn", ";", "//", "//action:pause", "ab;cd;e"}) {
      EXPECT_EQ(starts_with(text, other), text.starts_with(other)) << text << " " << other;
      EXPECT_EQ(equal(text, other), text == other) << text << " " << other;
      for (std::size_t start = 0; start <= text.size() + 1; ++start) {
        EXPECT_EQ(find_first_of(text, other, start), text.find_first_of(other, start))
            << text << " " << other << " " << start;
      }
    }
    EXPECT_EQ(find(text, ';'), text.find(';'));
    EXPECT_EQ(find(text, 'N', 1), text.find('N', 1));
  }
}

}  // namespace
}  // namespace units
