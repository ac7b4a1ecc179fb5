// SPDX-License-Identifier: Apache-2.0
// One character, one transition.
#include "benchmark/number_scanner.hpp"

#include <string_view>

#include "benchmark/checksum.hpp"
#include "units/digits.hpp"

namespace benchmark {

namespace {

constexpr std::array<std::string_view, 8> samples{"71023",  "-2881",     "+63.504", ".00251",
                                                  "8.1e+4", "-4.09E-12", "5..2",    "T-0x1F"};

using units::is_digit;
constexpr bool is_sign(char character) { return character == '+' || character == '-'; }
constexpr bool is_exponent(char character) { return character == 'e' || character == 'E'; }

}  // namespace

void NumberScanner::fill(std::uint32_t seed) {
  std::size_t place = 0;
  while (place < text_length) {
    seed = seed * 1'103'515'245u + 12'345u;
    for (const char character : samples[seed >> 16 & 7]) {
      if (place < text_length) text_[place++] = character;
    }
    if (place < text_length) text_[place++] = separator;
  }
}

NumberScanner::State NumberScanner::next(State state, char character) {
  switch (state) {
    case State::start:
      if (is_digit(character)) return State::whole;
      if (is_sign(character)) return State::sign;
      return character == '.' ? State::point : State::invalid;
    case State::sign:
      if (is_digit(character)) return State::whole;
      return character == '.' ? State::point : State::invalid;
    case State::whole:
      if (is_digit(character)) return State::whole;
      if (character == '.') return State::fraction;
      return is_exponent(character) ? State::exponent : State::invalid;
    case State::point:
      return is_digit(character) ? State::fraction : State::invalid;
    case State::fraction:
      if (is_digit(character)) return State::fraction;
      return is_exponent(character) ? State::exponent : State::invalid;
    case State::exponent:
      if (is_sign(character)) return State::exponent_sign;
      return is_digit(character) ? State::power : State::invalid;
    case State::exponent_sign:
    case State::power:
      return is_digit(character) ? State::power : State::invalid;
    case State::invalid:
      return State::invalid;
  }
  return State::invalid;
}

void NumberScanner::scan() {
  State state = State::start;
  for (const char character : text_) {
    if (character == separator) {
      ++ended_in_[static_cast<std::size_t>(state)];
      state = State::start;
      continue;
    }
    const State following = next(state, character);
    if (following != state) ++entered_[static_cast<std::size_t>(following)];
    state = following;
  }
}

// The same change again restores the text.
void NumberScanner::corrupt(std::size_t stride) {
  for (std::size_t place = 0; place < text_length; place += stride) {
    if (text_[place] != separator) text_[place] = static_cast<char>(text_[place] ^ 0x40);
  }
}

std::uint16_t NumberScanner::run(std::size_t stride) {
  ended_in_.fill(0);
  entered_.fill(0);
  scan();
  corrupt(stride);
  scan();
  corrupt(stride);
  std::uint16_t sum = 0;
  for (std::size_t i = 0; i < states; ++i) {
    sum = add_half_word(add_half_word(sum, ended_in_[i]), entered_[i]);
  }
  return sum;
}

}  // namespace benchmark
