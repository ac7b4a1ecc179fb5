// SPDX-License-Identifier: Apache-2.0
// A position among the tokens of a VHDL file, and moves to later ones.
#pragma once

#include <initializer_list>
#include <string_view>
#include <vector>

#include "tools/proof/vhdl_tokens.hpp"

namespace proof {

class VhdlCursor {
 public:
  // `tokens` must outlive this.
  explicit VhdlCursor(const std::vector<Token>& tokens) : tokens_(tokens) {}

  bool at_end() const { return place_ >= tokens_.size(); }
  std::size_t place() const { return place_; }
  const std::string& text_at(std::size_t place) const { return tokens_[place].text; }

  // The token here, or this many tokens ahead.
  bool is(std::string_view text, std::size_t distance = 0) const;
  bool is_one_of(std::initializer_list<std::string_view> texts) const;
  // The next of these texts outside of parentheses, from here on. Throws std::runtime_error where
  // there is none.
  std::size_t find(std::initializer_list<std::string_view> texts) const;

  void go_to(std::size_t place) { place_ = place; }
  void advance() { ++place_; }
  // Past this text; throws std::runtime_error where another one stands here.
  void expect(std::string_view text);
  void skip_past(std::string_view text) { place_ = find({text}) + 1; }
  void skip_to_end_of(std::string_view unit);
  void skip_label();
  void skip_parentheses();

 private:
  const std::vector<Token>& tokens_;
  std::size_t place_ = 0;
};

}  // namespace proof
