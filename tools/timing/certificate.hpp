// SPDX-License-Identifier: Apache-2.0
// A proof, in integers, that no solution of a linear program is larger than a bound.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tools/timing/linear_program.hpp"

namespace timing {

__extension__ using Wide = __int128;

// A price for each row, in fractions of a clock: `price / scale`.
struct Prices {
  std::int64_t scale = 1;
  std::vector<Wide> of_rows;
};

// The theorem of weak duality: where no price of a row "at most" is below 0, and each column's
// clocks are at most the sum of its factors times their prices, no solution has more clocks than
// the right sides times their prices. Rounded down, since clocks are whole. Nothing where the
// prices prove no bound, or a number does not fit.
std::optional<Clocks> proved_bound(const LinearProgram& program, const Prices& prices);

}  // namespace timing
