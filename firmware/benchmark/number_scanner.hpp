// SPDX-License-Identifier: Apache-2.0
// A state machine that finds what kinds of numbers are in a text.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace benchmark {

class NumberScanner {
 public:
  static constexpr std::size_t text_length = 660;

  void fill(std::uint32_t seed);
  // Scans the text as it is and again with every `stride`th character corrupted; then it
  // is as before.
  std::uint16_t run(std::size_t stride);

 private:
  enum class State : std::uint8_t {
    start,
    sign,
    whole,
    point,
    fraction,
    exponent,
    exponent_sign,
    power,
    invalid
  };
  static constexpr std::size_t states = 9;
  static constexpr char separator = ',';

  static State next(State state, char character);
  void scan();
  void corrupt(std::size_t stride);

  std::array<char, text_length> text_{};
  std::array<std::uint16_t, states> ended_in_{};  // numbers, by the last state
  std::array<std::uint16_t, states> entered_{};
};

}  // namespace benchmark
