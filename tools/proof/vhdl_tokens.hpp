// SPDX-License-Identifier: Apache-2.0
// The words of a VHDL file with their places, without comments (and so without PSL in comments).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace proof {

struct Token {
  enum class Kind { word, number, character, string, symbol };

  Kind kind{};
  std::string text;  // words in lower case
  std::size_t begin{};  // offsets in the file
  std::size_t end{};
};

// Throws std::runtime_error at a character that VHDL does not know here.
std::vector<Token> tokens_of(std::string_view text);

bool is_reserved(std::string_view word);
// and, or, xor, nand, nor, xnor.
bool is_logical(std::string_view word);

}  // namespace proof
