// SPDX-License-Identifier: Apache-2.0
// Figures in formulas, and the form of numbers.
#include "tools/figures/expression.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string_view>

#include "tools/formula/formula.hpp"

namespace figures {

namespace {

double value_of(std::string_view name, const Store& store, std::set<std::string>& used) {
  const std::size_t dot = name.find('.');
  const auto record = store.find(std::string(name.substr(0, dot)));
  const std::string value(dot == std::string_view::npos ? "" : name.substr(dot + 1));
  if (record == store.end() || !record->second.values.contains(value)) {
    throw std::runtime_error(fmt::format("there is no figure \"{}\"", name));
  }
  used.emplace(name);
  return record->second.values.at(value);
}

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
    const double value =
        formula::evaluate(std::string_view(expression).substr(0, colon),
                          [&](std::string_view name) { return value_of(name, store, used); });
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
