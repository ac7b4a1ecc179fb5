// SPDX-License-Identifier: Apache-2.0
// The words of a G-code line with their numbers as integers, by a reader independent of
// the firmware.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace report {

inline constexpr std::int64_t billionths = 1'000'000'000;

// A letter in upper case and the number after it in billionths. More than nine decimals are
// rounded, halves away from zero; beyond 10^9 the number stays there.
struct GcodeWord {
  char letter{};
  std::optional<std::int64_t> value;  // empty for a letter alone, as in G28 X
};

class GcodeWords {
 public:
  // Comments, quoted texts and what the message of M117 or M118 says are left out.
  explicit GcodeWords(std::string_view command);

  // The command after a G53.
  GcodeWords without_first() const;

  // Whether the line is this command; G1.1 is not G1.
  bool is(char letter, int code) const;
  bool has(char letter) const { return find(letter) != nullptr; }
  // The number after the first such letter that is not the command's own.
  std::optional<std::int64_t> value(char letter) const;
  // The command first; empty for a line that does not begin with a letter.
  const std::vector<GcodeWord>& all() const { return words_; }

 private:
  GcodeWords() = default;
  const GcodeWord* find(char letter) const;

  std::vector<GcodeWord> words_;
};

}  // namespace report
