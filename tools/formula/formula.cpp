// SPDX-License-Identifier: Apache-2.0
// A parser by recursive descent.
#include "tools/formula/formula.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <system_error>

namespace formula {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_part_of_name(char c) {
  return (c >= 'a' && c <= 'z') || is_digit(c) || c == '_' || c == '.';
}

class Parser {
 public:
  Parser(std::string_view text, const Values& values) : rest_(text), values_(values) {}

  double all() {
    const double value = sum();
    if (next() != '\0') throw std::runtime_error(fmt::format("\"{}\" is too much", rest_));
    return value;
  }

 private:
  double sum() {
    double value = product();
    for (char sign = next(); sign == '+' || sign == '-'; sign = next()) {
      rest_.remove_prefix(1);
      value += sign == '+' ? product() : -product();
    }
    return value;
  }

  double product() {
    double value = factor();
    for (char sign = next(); sign == '*' || sign == '/'; sign = next()) {
      rest_.remove_prefix(1);
      value = sign == '*' ? value * factor() : value / factor();
    }
    return value;
  }

  double factor() {
    const char first = next();
    if (first == '(') {
      return in_parentheses();
    }
    if (is_digit(first)) return number();
    std::size_t length = 0;
    while (length < rest_.size() && is_part_of_name(rest_[length])) ++length;
    if (length == 0) throw std::runtime_error("a number or a name is missing");
    const std::string_view name = rest_.substr(0, length);
    rest_.remove_prefix(length);
    if (name == "ln") return std::log(in_parentheses());
    if (name == "exp") return std::exp(in_parentheses());
    return values_(name);
  }

  double in_parentheses() {
    take('(');
    const double value = sum();
    take(')');
    return value;
  }

  double number() {
    double value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc()) throw std::runtime_error("a number is too large");
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }

  void take(char wanted) {
    if (next() != wanted) throw std::runtime_error(fmt::format("\"{}\" is missing", wanted));
    rest_.remove_prefix(1);
  }

  // The next character that is no blank; '\0' at the end.
  char next() {
    while (rest_.starts_with(' ')) rest_.remove_prefix(1);
    return rest_.empty() ? '\0' : rest_.front();
  }

  std::string_view rest_;
  const Values& values_;
};

}  // namespace

double evaluate(std::string_view text, const Values& values) { return Parser(text, values).all(); }

}  // namespace formula
