// SPDX-License-Identifier: Apache-2.0
// The search finds what is bad, the same with the same seed, within the limits of an input.
#include "tools/worst_inputs/search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "tools/worst_inputs/hard_inputs.hpp"

// What the handlers of the table need to be linked: none is called.
namespace platform {
std::uint32_t bus_read(std::uint32_t) { std::abort(); }
void bus_write(std::uint32_t, std::uint32_t) { std::abort(); }
bool enter_boot_loader() { std::abort(); }
}  // namespace platform

namespace worst_inputs {
namespace {

std::string joined(const SerialInput& input) {
  std::string bytes;
  for (const Piece& piece : input) bytes += piece.bytes;
  return bytes;
}

// As if the first task took long for digits, the last one for pauses.
Slices of_digits_and_pauses(const SerialInput& input) {
  Slices slices{};
  const std::string bytes = joined(input);
  slices.front() = static_cast<std::uint32_t>(
      std::ranges::count_if(bytes, [](char byte) { return byte >= '0' && byte <= '9'; }));
  for (const Piece& piece : input) slices.back() += piece.pause_us / 1'000;
  return slices;
}

template <class Measure>
Search::Measure of_each(Measure measure) {
  return [measure](const std::vector<SerialInput>& inputs) {
    std::vector<Slices> slices;
    for (const SerialInput& input : inputs) slices.push_back(measure(input));
    return slices;
  };
}

TEST(Search, finds_worse_inputs_than_chance) {
  constexpr int steps = 3'000;
  Search search(1, of_each(of_digits_and_pauses));
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
  Search one(7, measure), same(7, measure), other(8, measure);
  for (int i = 0; i < 200; ++i) {
    for (Search* search : {&one, &same, &other}) search->step(1);
  }
  EXPECT_EQ(one.worst(0).input, same.worst(0).input);
  EXPECT_NE(one.worst(0).input, other.worst(0).input);
}

TEST(Search, keeps_the_worst_of_each_task) {
  std::uint32_t calls = 0, longest = 0;
  Search search(1, of_each([&](const SerialInput&) {
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
  std::vector<SerialInput> tried;
  Search search(1, of_each([&](const SerialInput& input) {
                  tried.push_back(input);
                  return Slices{};
                }),
                hard);
  search.step(3);
  search.step(hard.size() + 2);
  EXPECT_TRUE(std::ranges::equal(std::span(tried).first(hard.size()), hard));
  EXPECT_EQ(tried.size(), hard.size() + 5);
  for (const SerialInput& input : hard) EXPECT_LE(bytes_of(input), most_bytes) << text_of(input);
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
