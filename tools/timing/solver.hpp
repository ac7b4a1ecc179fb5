// SPDX-License-Identifier: Apache-2.0
// The optimum of a linear program, as HiGHS finds it in floating point: a hint, not a proof.
#pragma once

#include <vector>

#include "tools/timing/linear_program.hpp"

namespace timing {

struct Solution {
  enum class Kind { optimal, infeasible, failed };
  Kind kind = Kind::failed;
  double clocks{};
  std::vector<double> passes;  // of each column
  std::vector<double> prices;  // of each row; of rows "at most" 0 or more
};

Solution solve(const LinearProgram& program);

}  // namespace timing
