// SPDX-License-Identifier: Apache-2.0
// Token by token of an expression.
#include "tools/proof/token_operators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

namespace proof {

namespace {

using Kind = Token::Kind;

class TokenOperators {
 public:
  TokenOperators(const VhdlText& text, const NameRelatives& relatives, MutantDraft& draft)
      : text_(text), relatives_(relatives), draft_(draft) {}

  void mutate_tokens(const Expression& expression) {
    for (std::size_t i = expression.tokens.first; i < expression.tokens.last; ++i) {
      const Token& token = text_.token(i);
      switch (token.kind) {
        case Kind::word:
          mutate_word(i, expression);
          break;
        case Kind::symbol:
          mutate_symbol(i, expression);
          break;
        case Kind::character:
          // Compared with the other value is what `relation` does.
          if ((token.text == "'0'" || token.text == "'1'") && i > 0 && word(i - 1) != "=" &&
              word(i - 1) != "/=") {
            mutate_token(i, expression.statement, "bit", token.text == "'0'" ? "'1'" : "'0'");
          }
          break;
        case Kind::string:
          mutate_string(i, expression);
          break;
        case Kind::number:
          mutate_number(i, expression);
          break;
      }
    }
  }

 private:
  const std::string& word(std::size_t i) const { return text_.word(i); }

  void mutate_token(std::size_t i, Span statement, const char* kind, const std::string& to) {
    draft_.replace(kind, {i, i + 1}, statement, {to});
  }

  void mutate_word(std::size_t i, const Expression& expression) {
    static const std::map<std::string, std::string> others{
        {"and", "or"}, {"or", "and"}, {"xor", "xnor"}, {"nand", "and"}, {"nor", "or"}};
    const auto other = others.find(word(i));
    if (other != others.end()) {
      mutate_token(i, expression.statement, "logic", other->second);
    } else if (word(i) == "not") {
      mutate_token(i, expression.statement, "logic", "");
    } else if (text_.is_name(i, expression.tokens)) {
      if (const std::string* other_name = relatives_.find(word(i), text_.is_field(i))) {
        mutate_token(i, expression.statement, "name", *other_name);
      }
    }
  }

  void mutate_symbol(std::size_t i, const Expression& expression) {
    static const std::map<std::string, std::vector<const char*>> relations{
        {"=", {"/="}},      {"/=", {"="}},       {"<", {"<=", ">="}},
        {"<=", {"<", ">"}}, {">", {">=", "<="}}, {">=", {">", "<"}}};
    static const std::map<std::string, const char*> arithmetic{{"+", "-"}, {"-", "+"}, {"*", "+"}};
    if (const auto found = relations.find(word(i)); found != relations.end()) {
      for (const char* to : found->second) mutate_token(i, expression.statement, "relation", to);
      // Bits have no order that anyone means.
      if (word(i) == "=" && i + 1 < expression.tokens.last &&
          text_.token(i + 1).kind != Kind::character) {
        mutate_token(i, expression.statement, "relation", ">=");
        mutate_token(i, expression.statement, "relation", "<=");
      }
    } else if (const auto sign = arithmetic.find(word(i));
               sign != arithmetic.end() && text_.has_operand_before(i, expression.tokens)) {
      mutate_token(i, expression.statement, "arithmetic", sign->second);
    } else if (word(i) == "&") {
      zero_parts(i, expression);
    }
  }

  // The name after a `&`; the first one of a chain where it is a name alone.
  void zero_parts(std::size_t i, const Expression& expression) {
    if (const auto name = text_.name_from(i + 1, expression.tokens)) zero_part(*name, expression);
    if (i > expression.tokens.first && text_.token(i - 1).kind == Kind::word &&
        (i - 1 == expression.tokens.first || word(i - 2) == "(" || word(i - 2) == ",") &&
        !is_reserved(word(i - 1))) {
      zero_part({i - 1, i}, expression);
    }
  }
  void zero_part(Span name, const Expression& expression) {
    const std::string value = text_.source(name);
    draft_.replace("zero", name, expression.statement, {fmt::format("({0} xor {0})", value)});
  }

  void mutate_string(std::size_t i, const Expression& expression) {
    std::string text = word(i);
    char& last = text[text.size() - 2];
    if (last == '0' || last == '1') {
      last = last == '0' ? '1' : '0';
      mutate_token(i, expression.statement, "bit", text);
    }
  }

  static std::optional<long> number(const std::string& text) {
    if (text.size() > 9 ||
        !std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; })) {
      return std::nullopt;
    }
    return std::stol(text);
  }

  void mutate_number(std::size_t i, const Expression& expression) {
    const auto value = number(word(i));
    if (!value) return;
    const auto is_direction = [this](std::size_t place) {
      return word(place) == "downto" || word(place) == "to";
    };
    const Span all = expression.tokens;
    // The right bound of a slice moves with the left one.
    if (i >= all.first + 2 && is_direction(i - 1) && text_.token(i - 2).kind == Kind::number) {
      return;
    }
    if (i + 2 < all.last && is_direction(i + 1) && text_.token(i + 2).kind == Kind::number) {
      const long right = number(word(i + 2)).value_or(0);
      for (const long step : {1L, -1L}) {
        if (std::min(*value, right) + step >= 0) {
          draft_.replace("number", {i, i + 3}, expression.statement,
                         {fmt::format("{} {} {}", *value + step, word(i + 1), right + step)});
        }
      }
      return;
    }
    mutate_token(i, expression.statement, "number", std::to_string(*value + 1));
    if (*value > 0) mutate_token(i, expression.statement, "number", std::to_string(*value - 1));
  }

  const VhdlText& text_;
  const NameRelatives& relatives_;
  MutantDraft& draft_;
};

}  // namespace

void mutate_tokens(const VhdlText& text, const NameRelatives& relatives,
                   const Expression& expression, MutantDraft& draft) {
  TokenOperators(text, relatives, draft).mutate_tokens(expression);
}

}  // namespace proof
