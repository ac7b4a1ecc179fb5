// SPDX-License-Identifier: Apache-2.0
// A second opinion: GLPK, which solves the program in whole numbers.
#pragma once

#include <optional>

#include "tools/timing/linear_program.hpp"

namespace timing {

// Nothing where the rows contradict each other. Throws std::runtime_error where GLPK gives up.
std::optional<double> optimum_in_integers(const LinearProgram& program);

}  // namespace timing
