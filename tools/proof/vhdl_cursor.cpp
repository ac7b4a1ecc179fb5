// SPDX-License-Identifier: Apache-2.0
// Parentheses are counted: text within them ends nothing.
#include "tools/proof/vhdl_cursor.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace proof {

bool VhdlCursor::is(std::string_view text, std::size_t distance) const {
  return place_ + distance < tokens_.size() && tokens_[place_ + distance].text == text;
}

bool VhdlCursor::is_one_of(std::initializer_list<std::string_view> texts) const {
  for (const std::string_view text : texts) {
    if (is(text)) return true;
  }
  return false;
}

void VhdlCursor::expect(std::string_view text) {
  if (!is(text)) {
    const std::string found = place_ < tokens_.size() ? tokens_[place_].text : "the end";
    throw std::runtime_error(
        fmt::format("'{}' stands where '{}' is expected, token {}", found, text, place_));
  }
  ++place_;
}

std::size_t VhdlCursor::find(std::initializer_list<std::string_view> texts) const {
  int depth = 0;
  for (std::size_t i = place_; i < tokens_.size(); ++i) {
    const std::string& text = tokens_[i].text;
    if (depth == 0) {
      for (const std::string_view wanted : texts) {
        if (text == wanted && tokens_[i].kind != Token::Kind::string) return i;
      }
    }
    depth += text == "(" ? 1 : text == ")" ? -1 : 0;
  }
  throw std::runtime_error(fmt::format("no '{}' follows token {}", *texts.begin(), place_));
}

void VhdlCursor::skip_to_end_of(std::string_view unit) {
  while (!(is("end") && is(unit, 1))) skip_past(";");
  skip_past(";");
}

void VhdlCursor::skip_label() {
  if (place_ + 1 < tokens_.size() && tokens_[place_].kind == Token::Kind::word && is(":", 1)) {
    place_ += 2;
  }
}

void VhdlCursor::skip_parentheses() {
  int depth = 0;
  do {
    depth += is("(") ? 1 : is(")") ? -1 : 0;
    ++place_;
  } while (depth > 0);
}

}  // namespace proof
