// SPDX-License-Identifier: Apache-2.0
// Places and spellings, for all operators alike.
#include "tools/proof/vhdl_text.hpp"

namespace proof {

using Kind = Token::Kind;

VhdlText::VhdlText(std::string_view text)
    : text_(text), tokens_(tokens_of(text)), outline_(outline_of(tokens_)) {}

std::string VhdlText::source(Span span) const {
  if (span.first >= span.last) return {};
  const std::size_t begin = tokens_[span.first].begin;
  return std::string(text_.substr(begin, tokens_[span.last - 1].end - begin));
}

std::string VhdlText::shown(Span span) const {
  std::string result;
  for (std::size_t i = span.first; i < span.last; ++i) {
    const std::string& text = word(i);
    const bool is_tight = result.empty() || text == ")" || text == "," || text == "." ||
                          text == ";" || text == "'" || result.back() == '.' ||
                          result.back() == '(' || (result.back() == '\'' && word(i - 1) == "'") ||
                          (text == "(" && i > span.first && tokens_[i - 1].kind == Kind::word &&
                           !is_reserved(word(i - 1)));
    result += (is_tight ? "" : " ") + text;
  }
  return result;
}

bool VhdlText::is_literal(Span span) const {
  if (span.first + 1 == span.last) return tokens_[span.first].kind != Kind::word;
  return word(span.first) == "(" && word(span.first + 1) == "others" && span.last - span.first <= 7;
}

bool VhdlText::is_one_relation(Span span) const {
  int relations = 0;
  for (std::size_t i = span.first; i < span.last; ++i) {
    relations += word(i) == "=" || word(i) == "/=" ? 1 : 0;
    if (is_logical(word(i)) || word(i) == "not") return false;
  }
  return relations == 1;
}

bool VhdlText::is_name(std::size_t i, Span all) const {
  return tokens_[i].kind == Kind::word && !is_reserved(word(i)) && !(i > 0 && word(i - 1) == "'") &&
         !(i + 1 < all.last && word(i + 1) == "=>");
}

bool VhdlText::has_operand_before(std::size_t i, Span span) const {
  return i > span.first && word(i - 1) != "(" && word(i - 1) != "," && word(i - 1) != "=>" &&
         !(tokens_[i - 1].kind == Kind::word && is_reserved(word(i - 1)));
}

std::optional<Span> VhdlText::name_from(std::size_t i, Span within) const {
  const std::size_t first = i;
  if (tokens_[i].kind != Kind::word || is_reserved(word(i))) return std::nullopt;
  for (++i; i < within.last;) {
    if (word(i) == "." && i + 1 < within.last) {
      i += 2;
    } else if (word(i) == "(") {
      i = past_parentheses(i);
    } else {
      break;
    }
  }
  return Span{first, i};
}

std::size_t VhdlText::past_parentheses(std::size_t i) const {
  int depth = 0;
  do {
    depth += word(i) == "(" ? 1 : word(i) == ")" ? -1 : 0;
    ++i;
  } while (depth > 0 && i < tokens_.size());
  return i;
}

}  // namespace proof
