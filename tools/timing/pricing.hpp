// SPDX-License-Identifier: Apache-2.0
// Prices that prove a bound, from prices of the facts alone.
#pragma once

#include <cstdint>
#include <vector>

#include "tools/timing/certificate.hpp"

namespace timing {

// With any prices of the facts, 0 or more, in fractions of a clock, the others follow: a node's is
// the longest way to the end, a loop's is what a round takes. The bound that they prove is the
// least for these prices of the facts; with those of an optimal dual solution it is the optimum
// (Geoffrion, "Lagrangean Relaxation for Integer Programming", 1974). Throws std::overflow_error
// where a number does not fit.
Prices price(const Networks& networks, std::int64_t scale, const std::vector<Wide>& of_facts);

}  // namespace timing
