// SPDX-License-Identifier: Apache-2.0
// Formulas of numbers and names, in figures of pages and in calculations of parts.
#pragma once

#include <functional>
#include <string_view>

namespace formula {

// The value of a name; throws std::runtime_error where it has none. Names are of lower-case
// letters, digits, '_' and '.'.
using Values = std::function<double(std::string_view name)>;

// Numbers, names, + - * /, parentheses, ln() and exp(). Throws std::runtime_error where the text
// cannot be read, and what `values` throws.
double evaluate(std::string_view text, const Values& values);

}  // namespace formula
