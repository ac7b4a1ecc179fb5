// SPDX-License-Identifier: Apache-2.0
// One iteration is about 190 000 instructions.
#include "benchmark/core_work.hpp"

#include "benchmark/checksum.hpp"

namespace benchmark {

namespace {

constexpr std::uint32_t seed = 0x5EED;
constexpr std::int16_t searches = 40;
constexpr std::int16_t matrix_rounds = 4;
constexpr std::size_t scanner_rounds = 4;
constexpr std::size_t shortest_stride = 7;

}  // namespace

void CoreWork::prepare(std::string_view) {
  list_.fill(seed);
  matrix_.fill(seed);
  scanner_.fill(seed);
}

ProcessorResult CoreWork::run(std::uint32_t iterations) {
  std::uint16_t sum = 0;
  for (std::uint32_t i = 0; i < iterations; ++i) {
    sum = add_half_word(sum, iterate(static_cast<std::int16_t>(i & 0xF)));
  }
  return {.units = iterations, .checksum = sum};
}

std::uint16_t CoreWork::iterate(std::int16_t variation) {
  std::uint16_t sum = 0;
  for (std::int16_t search = 0; search < searches; ++search) {
    const auto* found = list_.find(static_cast<std::int16_t>((7 * search + variation) % 47));
    list_.reverse();
    sum = found != nullptr ? add_half_word(sum, static_cast<std::uint16_t>(found->value))
                           : static_cast<std::uint16_t>(sum + 1);
  }
  list_.sort_by_value();
  sum = add_half_word(sum, list_.checksum());
  for (std::int16_t round = 0; round < matrix_rounds; ++round) {
    const auto factor = static_cast<std::int16_t>(list_.first_value() + variation + round);
    sum = add_half_word(sum, matrix_.run(factor));
  }
  for (std::size_t round = 0; round < scanner_rounds; ++round) {
    sum = add_half_word(sum, scanner_.run(shortest_stride + round));
  }
  list_.sort_by_place();
  return add_half_word(sum, list_.checksum());
}

}  // namespace benchmark
