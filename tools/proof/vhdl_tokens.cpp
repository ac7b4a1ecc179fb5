// SPDX-License-Identifier: Apache-2.0
// VHDL-2008's lexical elements, as far as the chip's sources use them.
#include "tools/proof/vhdl_tokens.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <stdexcept>

namespace proof {

namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_word_part(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

class Lexer {
 public:
  explicit Lexer(std::string_view text) : text_(text) {}

  std::vector<Token> tokens() {
    for (skip(); place_ < text_.size(); skip()) read();
    return std::move(tokens_);
  }

 private:
  char at(std::size_t distance) const {
    return place_ + distance < text_.size() ? text_[place_ + distance] : '\0';
  }

  void skip() {
    while (place_ < text_.size()) {
      if (text_.substr(place_).starts_with("--")) {
        place_ = std::min(text_.find('\n', place_), text_.size());
      } else if (std::isspace(static_cast<unsigned char>(text_[place_])) != 0) {
        ++place_;
      } else {
        return;
      }
    }
  }

  void add(Token::Kind kind, std::size_t length) {
    Token token{kind, std::string(text_.substr(place_, length)), place_, place_ + length};
    if (kind == Token::Kind::word) {
      std::ranges::transform(token.text, token.text.begin(),
                             [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    }
    tokens_.push_back(std::move(token));
    place_ += length;
  }

  // Up to the quotation mark that closes; two of them stand for one.
  std::size_t string_length(std::size_t distance) const {
    for (++distance; at(distance) != '\0'; ++distance) {
      if (at(distance) == '"') {
        if (at(distance + 1) != '"') return distance + 1;
        ++distance;
      }
    }
    throw std::runtime_error("a string has no end");
  }

  // After a name or `)` it leads an attribute or a qualified expression.
  bool is_tick() const {
    if (tokens_.empty()) return false;
    const Token& before = tokens_.back();
    return before.text == ")" || (before.kind == Token::Kind::word && !is_reserved(before.text));
  }

  void read() {
    const char c = at(0);
    if (is_letter(c)) {
      std::size_t length = 1;
      while (is_word_part(at(length))) ++length;
      at(length) == '"' && length <= 2 ? add(Token::Kind::string, string_length(length))
                                       : add(Token::Kind::word, length);
    } else if (is_digit(c)) {
      std::size_t length = 1;
      while (is_word_part(at(length)) || at(length) == '#' ||
             (at(length) == '.' && is_digit(at(length + 1)))) {
        ++length;
      }
      add(Token::Kind::number, length);
    } else if (c == '"') {
      add(Token::Kind::string, string_length(0));
    } else if (c == '\'' && at(2) == '\'' && !is_tick()) {
      add(Token::Kind::character, 3);
    } else {
      read_symbol();
    }
  }

  void read_symbol() {
    static constexpr std::array<std::string_view, 11> long_symbols{
        "?/=", "=>", "<=", ">=", ":=", "/=", "**", "<>", "??", "?=", "?<"};
    for (const std::string_view symbol : long_symbols) {
      if (text_.substr(place_).starts_with(symbol)) {
        add(Token::Kind::symbol, symbol.size());
        return;
      }
    }
    static constexpr std::string_view symbols = "()+-*/&=<>;:,.'|?@{}[]!";  // PSL's too
    if (!symbols.contains(at(0))) {
      throw std::runtime_error(fmt::format("'{}' is no part of VHDL here", at(0)));
    }
    add(Token::Kind::symbol, 1);
  }

  std::string_view text_;
  std::size_t place_ = 0;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> tokens_of(std::string_view text) { return Lexer(text).tokens(); }

bool is_reserved(std::string_view word) {
  static const std::set<std::string_view> words{
      "abs",       "alias",    "all",      "and",     "architecture", "array",     "assert",
      "attribute", "begin",    "block",    "body",    "case",         "component", "constant",
      "downto",    "else",     "elsif",    "end",     "entity",       "exit",      "file",
      "for",       "function", "generate", "generic", "if",           "impure",    "in",
      "inout",     "is",       "library",  "loop",    "map",          "mod",       "nand",
      "new",       "next",     "nor",      "not",     "null",         "of",        "on",
      "open",      "or",       "others",   "out",     "package",      "port",      "procedure",
      "process",   "pure",     "range",    "record",  "rem",          "report",    "return",
      "select",    "severity", "shared",   "signal",  "sll",          "srl",       "subtype",
      "then",      "to",       "type",     "until",   "use",          "variable",  "wait",
      "when",      "while",    "with",     "xnor",    "xor"};
  return words.contains(word);
}

bool is_logical(std::string_view word) {
  return word == "and" || word == "or" || word == "xor" || word == "nand" || word == "nor" ||
         word == "xnor";
}

}  // namespace proof
