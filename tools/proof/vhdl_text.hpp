// SPDX-License-Identifier: Apache-2.0
// A VHDL file with its tokens and their outline, and what the operators ask about its expressions.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/proof/vhdl_outline.hpp"

namespace proof {

class VhdlText {
 public:
  // `text` must outlive this. Throws as `tokens_of` and `outline_of` do.
  explicit VhdlText(std::string_view text);

  const Outline& outline() const { return outline_; }
  std::size_t size() const { return tokens_.size(); }
  const Token& token(std::size_t i) const { return tokens_[i]; }
  const std::string& word(std::size_t i) const { return tokens_[i].text; }

  // As it stands in the file.
  std::string source(Span span) const;
  // The tokens with single blanks.
  std::string shown(Span span) const;

  bool is_literal(Span span) const;
  // One `=` or `/=` and nothing logical.
  bool is_one_relation(Span span) const;
  // A name that another name may take the place of: no attribute, no formal.
  bool is_name(std::size_t i, Span all) const;
  bool is_field(std::size_t i) const { return i > 0 && word(i - 1) == "."; }
  bool has_operand_before(std::size_t i, Span span) const;

  // The name that begins at a token, with fields, indices and attributes; nothing where
  // no name begins.
  std::optional<Span> name_from(std::size_t i, Span within) const;
  // The token after the parenthesis that closes the one at `i`.
  std::size_t past_parentheses(std::size_t i) const;

 private:
  std::string_view text_;
  std::vector<Token> tokens_;
  Outline outline_;
};

}  // namespace proof
