// SPDX-License-Identifier: Apache-2.0
// Makes inputs, and new ones of those that have been the worst.
#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "tools/worst_inputs/serial_input.hpp"

namespace worst_inputs {

class Breeder {
 public:
  explicit Breeder(std::uint64_t seed) : random_(seed) {}

  // A few lines of the table of commands, with numbers of all lengths.
  SerialInput random();
  // With one to four changes: in a number, a letter, a line, a byte, a pause.
  SerialInput changed(SerialInput input);
  // The beginning of one, the end of the other.
  SerialInput crossed(const SerialInput& one, const SerialInput& other);

  // Of its random numbers: all that it makes follows from it. Throws std::runtime_error where the
  // text is none.
  std::string state() const;
  void resume(const std::string& state);

  // Evenly one of 0 to end - 1.
  std::size_t below(std::size_t end);
  bool one_in(std::size_t times) { return below(times) == 0; }

 private:
  std::string line();
  std::string number();
  std::string long_number();
  void change(SerialInput& input);
  void change_number(std::string& bytes);
  void change_line(std::string& bytes);
  void change_byte(std::string& bytes);
  void split(SerialInput& input, std::size_t piece);

  std::mt19937_64 random_;
};

// Bred ones are cut there: two of the longest lines.
inline constexpr std::size_t most_bytes = 224;

}  // namespace worst_inputs
