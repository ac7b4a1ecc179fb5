// SPDX-License-Identifier: Apache-2.0
// Calculations of the interface board's values: formulas of names, and numbers with units.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace wiring {

// Values of names, in SI units.
using Numbers = std::map<std::string, double, std::less<>>;

// Numbers, names, + - * /, parentheses, ln() and exp(). Throws std::runtime_error with the formula
// where it cannot be read or a name has no value.
double value_of(std::string_view formula, const Numbers& numbers);

// As people write it: "4.7 kΩ", "68 nF", "0.52"; three digits.
std::string shown(double value, std::string_view unit);

}  // namespace wiring
