// SPDX-License-Identifier: Apache-2.0
// Each clock beyond an instruction's first is attributed to its cause.
#include "tools/benchmark/clock_use.hpp"

#include <gtest/gtest.h>

#include "sim/processor/encode.hpp"
#include "tests/processor/encode_compressed.hpp"

namespace {

namespace encode = processor::encode;
using benchmarks::ClockUse;
using benchmarks::Event;
using benchmarks::Waiting;

constexpr std::uint32_t start = 0x80000000;

// Instructions one after the other, or at an address of their own, each with its clocks.
class Executed {
 public:
  Executed() { then(encode::nop(), 1); }
  Executed& then(std::uint32_t word, std::uint64_t clocks) { return at(next_, word, clocks); }
  Executed& at(std::uint32_t address, std::uint32_t word, std::uint64_t clocks) {
    clock_ += clocks;
    use_.add(address, word, clock_);
    next_ = address + ((word & 3) == 3 ? 4 : 2);
    return *this;
  }
  const ClockUse& use() const { return use_; }

 private:
  ClockUse use_;
  std::uint32_t next_ = start;
  std::uint64_t clock_ = 100;
};

TEST(clock_use, straight_code_takes_a_clock_each) {
  Executed executed;
  executed.then(encode::add_immediate(1, 1, 1), 1).then(encode::add_immediate(2, 1, 1), 1);
  EXPECT_EQ(executed.use().instructions(), 3u);
  EXPECT_EQ(executed.use().clocks(), 3u);
  for (std::size_t i = 0; i < benchmarks::waiting_kinds; ++i) {
    EXPECT_EQ(executed.use().waited(static_cast<Waiting>(i)), 0u);
  }
}

TEST(clock_use, waiting_for_a_late_result_is_the_readers) {
  Executed executed;
  executed.then(encode::load(2, 5, 2, 0), 1).then(encode::operation(0, 0, 6, 4, 5), 2);
  executed.then(encode::operation(0, 1, 7, 6, 6), 1).then(encode::nop(), 1);
  executed.then(encode::store(2, 7, 2, 0), 1);
  EXPECT_EQ(executed.use().waited(Waiting::late_result), 1u);
  EXPECT_EQ(executed.use().count(Event::late_result_read_next), 1u);
  EXPECT_EQ(executed.use().count(Event::late_result_read_second), 1u);
  EXPECT_EQ(executed.use().count(Event::load), 1u);
  EXPECT_EQ(executed.use().count(Event::store), 1u);
  EXPECT_EQ(executed.use().count(Event::multiplication), 1u);
}

TEST(clock_use, compressed_instructions_count_by_what_they_stand_for) {
  Executed executed;
  executed.then(encode::compressed::load_from_sp(15, 8), 1);
  executed.then(encode::compressed::add(1, 15), 2);
  EXPECT_EQ(executed.use().waited(Waiting::late_result), 1u);
  EXPECT_EQ(executed.use().count(Event::compressed), 2u);
}

TEST(clock_use, branches_count_by_where_they_went) {
  Executed executed;
  executed.then(encode::branch(1, 4, 5, 16), 1).then(encode::nop(), 1);
  executed.then(encode::branch(1, 4, 5, 64), 1).at(start + 0x100, encode::nop(), 2);
  executed.then(encode::branch(1, 4, 5, -64), 1).at(start, encode::nop(), 2);
  executed.then(encode::branch(1, 4, 5, -64), 1).then(encode::nop(), 3);
  EXPECT_EQ(executed.use().count(Event::branch_not_taken), 2u);
  EXPECT_EQ(executed.use().count(Event::branch_taken_forward), 1u);
  EXPECT_EQ(executed.use().count(Event::branch_taken_backward), 1u);
  EXPECT_EQ(executed.use().waited(Waiting::branch), 4u);
  EXPECT_EQ(executed.use().waited(Waiting::other), 0u);
  EXPECT_EQ(executed.use().waited(Waiting::jump), 0u);
}

TEST(clock_use, a_division_behind_a_jump_has_its_own_clocks) {
  Executed executed;
  executed.then(encode::jump_and_link(1, 0x40), 1);
  executed.at(start + 0x44, encode::operation(4, 1, 5, 6, 7), 19).then(encode::nop(), 1);
  EXPECT_EQ(executed.use().waited(Waiting::jump), 1u);
  EXPECT_EQ(executed.use().waited(Waiting::division), 17u);
  EXPECT_EQ(executed.use().count(Event::division), 1u);
  EXPECT_EQ(executed.use().count(Event::jump_direct), 1u);
}

TEST(clock_use, what_has_no_known_cause_is_reported) {
  Executed executed;
  executed.then(encode::nop(), 4);
  EXPECT_EQ(executed.use().waited(Waiting::other), 3u);
}

TEST(clock_use, a_result_that_is_the_next_address_or_condition_is_seen) {
  Executed executed;
  executed.then(encode::add_immediate(5, 5, 4), 1).then(encode::load(2, 6, 5, 0), 1);
  executed.then(encode::add_immediate(7, 7, 1), 1).then(encode::branch(1, 4, 7, 16), 1);
  EXPECT_EQ(executed.use().count(Event::result_is_next_address), 1u);
  EXPECT_EQ(executed.use().count(Event::result_is_next_condition), 1u);
}

}  // namespace
