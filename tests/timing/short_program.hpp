// SPDX-License-Identifier: Apache-2.0
// Programs of a few instructions, and the bound of the function in them.
#pragma once

#include <optional>
#include <vector>

#include "sim/processor/encode.hpp"
#include "tools/timing/analysis.hpp"

namespace timing {

// The function begins so many bytes behind the start.
inline constexpr Address setup_bytes = 8;

Program program_of(const std::vector<processor::encode::Word>& words);

// if (a0 != 0) a division; while (a1 != 0) a1 = *a1;
Program with_choices();

Costs true_costs();
std::optional<Clocks> bound_of(const Program& program, const Costs& costs);

}  // namespace timing
