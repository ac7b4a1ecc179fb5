// SPDX-License-Identifier: Apache-2.0
// A parser of formulas by recursive descent, and the form of numbers.
#include "tools/wiring/formula.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <system_error>

namespace wiring {
namespace {

bool is_part_of_name(char c) {
  return std::islower(static_cast<unsigned char>(c)) || c == '_' ||
         std::isdigit(static_cast<unsigned char>(c));
}

class Parser {
 public:
  Parser(std::string_view text, const Numbers& numbers) : rest_(text), numbers_(numbers) {}

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
    if (std::isdigit(static_cast<unsigned char>(first))) return number();
    std::size_t length = 0;
    while (length < rest_.size() && is_part_of_name(rest_[length])) ++length;
    if (length == 0) throw std::runtime_error("a number or a name is missing");
    const std::string_view name = rest_.substr(0, length);
    rest_.remove_prefix(length);
    if (name == "ln") return std::log(in_parentheses());
    if (name == "exp") return std::exp(in_parentheses());
    const auto found = numbers_.find(name);
    if (found == numbers_.end()) throw std::runtime_error(fmt::format("{} has no value", name));
    return found->second;
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

  char next() {
    while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
    return rest_.empty() ? '\0' : rest_.front();
  }

  std::string_view rest_;
  const Numbers& numbers_;
};

struct Prefix {
  double factor;
  std::string_view name;
};

constexpr std::array prefixes{Prefix{1e6, "M"},  Prefix{1e3, "k"},  Prefix{1, ""},
                              Prefix{1e-3, "m"}, Prefix{1e-6, "µ"}, Prefix{1e-9, "n"},
                              Prefix{1e-12, "p"}};

}  // namespace

double value_of(std::string_view formula, const Numbers& numbers) {
  try {
    const double value = Parser(formula, numbers).all();
    if (!std::isfinite(value)) throw std::runtime_error("it has no finite value");
    return value;
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("formula \"{}\": {}", formula, error.what()));
  }
}

std::string shown(double value, std::string_view unit) {
  if (unit.empty() || value == 0) {
    return std::abs(value) >= 1000 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
  }
  for (const Prefix& prefix : prefixes) {
    // Capacitors are sold by the microfarad.
    if (unit == "F" && prefix.name == "m") continue;
    // What would be rounded up to 1000 belongs to the next prefix.
    if (std::abs(value) >= prefix.factor * 0.9995 || prefix.factor == prefixes.back().factor) {
      const double number = value / prefix.factor;
      return std::abs(number) >= 1000 ? fmt::format("{:.0f} {}{}", number, prefix.name, unit)
                                      : fmt::format("{:.3g} {}{}", number, prefix.name, unit);
    }
  }
  return {};
}

}  // namespace wiring
