// SPDX-License-Identifier: Apache-2.0
// The search finds what is bad, the same with the same seed, within the limits of an input.
#include "tools/worst_inputs/search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "tools/worst_inputs/hard_inputs.hpp"

namespace worst_inputs {
namespace {

std::string joined(const SerialInput& input) {
  std::string bytes;
  for (const Piece& piece : input) bytes += piece.bytes;
  return bytes;
}

// As if the first task took long for some digits, the last one for pauses.
Slices of_digits_and_pauses(const SerialInput& input) {
  Slices slices{};
  const std::string bytes = joined(input);
  slices.front() = static_cast<std::uint32_t>(
      std::ranges::count_if(bytes, [](char byte) { return byte == '7' || byte == '9'; }));
  for (const Piece& piece : input) slices.back() += piece.pause_us / 1'000;
  return slices;
}

template <class Measure>
Search::Measure of_each(Measure measure) {
  return [measure](std::size_t, const std::vector<SerialInput>& inputs) {
    std::vector<Slices> slices;
    for (const SerialInput& input : inputs) slices.push_back(measure(input));
    return slices;
  };
}

TEST(Search, finds_worse_inputs_than_chance) {
  constexpr int steps = 3'000;
  Search search(1, 1, of_each(of_digits_and_pauses));
  Breeder chance(1);
  std::uint32_t by_chance = 0, pauses_by_chance = 0;
  for (int i = 0; i < steps; ++i) {
    search.step(1);
    const Slices slices = of_digits_and_pauses(chance.random());
    by_chance = std::max(by_chance, slices.front());
    pauses_by_chance = std::max(pauses_by_chance, slices.back());
  }
  EXPECT_EQ(search.inputs(), static_cast<std::uint64_t>(steps));
  EXPECT_GT(search.worst(0).clocks, by_chance + by_chance / 4);
  EXPECT_EQ(of_digits_and_pauses(search.worst(0).input).front(), search.worst(0).clocks);
  EXPECT_GT(search.worst(pass_place).clocks, pauses_by_chance + pauses_by_chance / 4);
}

TEST(Search, is_the_same_with_the_same_seed) {
  const auto measure = of_each(of_digits_and_pauses);
  Search one(7, 2, measure), same(7, 2, measure), other(8, 2, measure);
  for (int i = 0; i < 200; ++i) {
    for (Search* search : {&one, &same, &other}) search->step(1);
  }
  EXPECT_EQ(one.worst(0).input, same.worst(0).input);
  EXPECT_NE(one.worst(0).input, other.worst(0).input);
}

TEST(Search, goes_on_as_if_it_had_not_been_stopped) {
  const auto measure = of_each(of_digits_and_pauses);
  Search whole(3, 2, measure, hard_inputs()), first_part(3, 2, measure, hard_inputs());
  for (int i = 0; i < 20; ++i) whole.step(16);
  for (int i = 0; i < 11; ++i) first_part.step(16);
  Search second_part(99, 2, measure, hard_inputs());
  second_part.resume(first_part.state());
  for (int i = 0; i < 9; ++i) second_part.step(16);
  EXPECT_EQ(second_part.inputs(), whole.inputs());
  EXPECT_EQ(second_part.state(), whole.state());
  EXPECT_EQ(second_part.worst(0).input, whole.worst(0).input);
  Search other_starts(3, 3, measure);
  EXPECT_THROW(other_starts.resume(whole.state()), std::runtime_error);
  for (const std::string& state :
       {std::string("nothing"), std::string(), whole.state().substr(9)}) {
    EXPECT_THROW(second_part.resume(state), std::runtime_error);
  }
}

TEST(Search, keeps_the_worst_of_each_task) {
  std::uint32_t calls = 0, longest = 0;
  Search search(1, 1, of_each([&](const SerialInput&) {
                  Slices slices{};
                  slices[3] = ++calls * 7'919 % 1'000;
                  longest = std::max(longest, slices[3]);
                  return slices;
                }));
  for (int i = 0; i < 100; ++i) {
    search.step(1);
    EXPECT_EQ(search.worst(3).clocks, longest);
  }
}

TEST(Search, begins_with_the_inputs_that_it_is_given) {
  const std::vector<SerialInput> hard = hard_inputs();
  std::array<std::vector<SerialInput>, 2> tried;
  Search search(
      1, 2,
      [&](std::size_t start, const std::vector<SerialInput>& inputs) {
        tried.at(start).insert(tried.at(start).end(), inputs.begin(), inputs.end());
        return std::vector<Slices>(inputs.size());
      },
      hard);
  for (const std::size_t inputs : {std::size_t{3}, std::size_t{5}, hard.size(), hard.size()}) {
    search.step(inputs);
  }
  for (const auto& behind_one : tried) {
    EXPECT_TRUE(std::ranges::equal(std::span(behind_one).first(hard.size()), hard));
  }
  EXPECT_EQ(tried[0].size() + tried[1].size(), 2 * hard.size() + 8);
}

// As if it took long for pauses behind one start, and for digits behind the other.
TEST(Search, breeds_for_each_start_by_itself) {
  std::vector<std::size_t> behind;
  Search search(1, 3, [&](std::size_t start, const std::vector<SerialInput>& inputs) {
    behind.push_back(start);
    std::vector<Slices> all;
    for (const SerialInput& input : inputs) {
      Slices slices = of_digits_and_pauses(input);
      if (start == 1) slices.front() = slices.back();
      if (start == 2) slices.front() = 0;
      all.push_back(slices);
    }
    return all;
  });
  for (int i = 0; i < 300; ++i) search.step(8);
  EXPECT_EQ(search.inputs(), 2'400U);
  EXPECT_TRUE(std::ranges::equal(std::span(behind).first(4), std::vector<std::size_t>{0, 1, 2, 0}));
  const auto measured = [](const Found& found) { return of_digits_and_pauses(found.input); };
  EXPECT_EQ(measured(search.worst(0, 0)).front(), search.worst(0, 0).clocks);
  EXPECT_EQ(measured(search.worst(0, 1)).back(), search.worst(0, 1).clocks);
  EXPECT_EQ(search.worst(0, 2).clocks, 0U);
  const Found& worst = search.worst(0);
  EXPECT_EQ(worst.clocks, std::max(search.worst(0, 0).clocks, search.worst(0, 1).clocks));
  EXPECT_EQ(worst.clocks, search.worst(0, worst.start).clocks);
}

TEST(Breeder, keeps_to_the_longest_input_and_reaches_every_command) {
  Breeder breeder(3);
  SerialInput input = breeder.random();
  std::set<std::string> words;
  for (int i = 0; i < 20'000; ++i) {
    input = breeder.one_in(20)  ? breeder.random()
            : breeder.one_in(5) ? breeder.crossed(input, breeder.random())
                                : breeder.changed(input);
    ASSERT_FALSE(input.empty());
    ASSERT_LE(bytes_of(input), most_bytes);
    for (const Piece& piece : input) ASSERT_FALSE(piece.bytes.empty());
    const std::string bytes = joined(breeder.random());
    words.insert(bytes.substr(0, bytes.find_first_of(" \nXYZEFSPTIJKRDLNWOHABCMQUV-*(", 1)));
  }
  for (const char* word : {"G1", "G2", "G28", "M105", "M503", "M112", "M999", "T0"}) {
    EXPECT_TRUE(words.contains(word)) << word;
  }
}

TEST(SerialInput, is_shown_on_one_line) {
  EXPECT_EQ(text_of({{.pause_us = 0, .bytes = "G1\n"}, {.pause_us = 250, .bytes = "M\x07\xff"}}),
            "G1\\n <250 us> M\\x07\\xff");
}

}  // namespace
}  // namespace worst_inputs
