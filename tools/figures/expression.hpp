// SPDX-License-Identifier: Apache-2.0
// Numbers as pages show them: a figure, or what follows from some.
#pragma once

#include <set>
#include <string>

#include "tools/figures/store.hpp"

namespace figures {

// GROUP.VALUE, numbers, + - * / and parentheses; after a colon the number of decimals:
// "washer.max_deviation_mm * 80 : 2". Without it the value must be whole. Thousands are set apart
// by a space from 10 000 on. Adds "GROUP.VALUE" of each figure to `used`. Throws
// std::runtime_error, with the expression, where it names no figure or cannot be read.
std::string shown(const std::string& expression, const Store& store, std::set<std::string>& used);

}  // namespace figures
