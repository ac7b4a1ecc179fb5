// SPDX-License-Identifier: Apache-2.0
// Formulas of known numbers, and the form of numbers.
#include "tools/wiring/formula.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "tools/formula/formula.hpp"

namespace wiring {
namespace {

struct Prefix {
  double factor;
  std::string_view name;
};

constexpr std::array prefixes{Prefix{1e6, "M"},  Prefix{1e3, "k"},  Prefix{1, ""},
                              Prefix{1e-3, "m"}, Prefix{1e-6, "µ"}, Prefix{1e-9, "n"},
                              Prefix{1e-12, "p"}};

}  // namespace

double value_of(std::string_view text, const Numbers& numbers) {
  try {
    const double value = formula::evaluate(text, [&](std::string_view name) {
      const auto found = numbers.find(name);
      if (found == numbers.end()) throw std::runtime_error(fmt::format("{} has no value", name));
      return found->second;
    });
    if (!std::isfinite(value)) throw std::runtime_error("it has no finite value");
    return value;
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("formula \"{}\": {}", text, error.what()));
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
