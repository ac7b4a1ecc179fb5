// SPDX-License-Identifier: Apache-2.0
// A parser by recursive descent, and the form of numbers.
#include "tools/figures/expression.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>

namespace figures {

namespace {

bool is_part_of_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
}

class Parser {
 public:
  Parser(std::string_view text, const Store& store, std::set<std::string>& used)
      : rest_(text), store_(store), used_(used) {}

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
      rest_.remove_prefix(1);
      const double value = sum();
      if (next() != ')') {
        throw std::runtime_error("a parenthesis is open");
      }
      rest_.remove_prefix(1);
      return value;
    }
    return first >= '0' && first <= '9' ? number() : figure();
  }

  double number() {
    double value = 0;
    const auto end = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value).ptr;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return value;
  }

  double figure() {
    std::size_t length = 0;
    while (length < rest_.size() && is_part_of_name(rest_[length])) ++length;
    const std::string name(rest_.substr(0, length));
    rest_.remove_prefix(length);
    const std::size_t dot = name.find('.');
    const auto record = store_.find(name.substr(0, dot));
    if (dot == std::string::npos || record == store_.end() ||
        !record->second.values.contains(name.substr(dot + 1))) {
      throw std::runtime_error(fmt::format("there is no figure \"{}\"", name));
    }
    used_.insert(name);
    return record->second.values.at(name.substr(dot + 1));
  }

  // The next character that is no blank; '\0' at the end.
  char next() {
    while (rest_.starts_with(' ')) rest_.remove_prefix(1);
    return rest_.empty() ? '\0' : rest_.front();
  }

  std::string_view rest_;
  const Store& store_;
  std::set<std::string>& used_;
};

std::string with_thousands_set_apart(const std::string& number) {
  const std::size_t point = std::min(number.find('.'), number.size());
  const std::size_t sign = number.starts_with('-') ? 1 : 0;
  std::string text = number;
  if (point - sign > 4) {
    for (std::size_t at = point - 3; at > sign && at < point; at -= 3) text.insert(at, " ");
  }
  return text;
}

int decimals_of(const std::string& text) {
  std::size_t length = 0;
  const int decimals = std::stoi(text, &length);
  if (decimals < 0 || decimals > 9) throw std::runtime_error("0 to 9 decimals are possible");
  return decimals;
}

}  // namespace

std::string shown(const std::string& expression, const Store& store, std::set<std::string>& used) {
  try {
    const std::size_t colon = expression.find(':');
    const double value = Parser(std::string_view(expression).substr(0, colon), store, used).all();
    if (colon == std::string::npos) {
      if (std::abs(value - std::round(value)) > 1e-9 * std::abs(value)) {
        throw std::runtime_error(fmt::format("{} is not whole: say with how many decimals", value));
      }
      return with_thousands_set_apart(fmt::format("{:.0f}", value));
    }
    const int decimals = decimals_of(expression.substr(colon + 1));
    return with_thousands_set_apart(fmt::format("{:.{}f}", value, decimals));
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("{}: {}", expression, error.what()));
  }
}

}  // namespace figures
