// SPDX-License-Identifier: Apache-2.0
// Rounds of loops as the source declares them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tools/timing/flow.hpp"
#include "tools/timing/loops.hpp"
#include "tools/timing/program.hpp"

namespace timing {

// How often the loop goes round in a run of it; nothing where no marker says so beyond doubt.
// `graph`: the ways of `flow` that may be taken; `loops`: all of it.
//
// A marker has no instruction of its own but the address of the next one, so the address alone
// does not always say in which loop it lies. It counts for the innermost loop, with exceptions:
// - It lies at this loop's start: it may as well lie in front of the loop. It counts for the
//   outermost of the loops around it in which its object does not end.
// - Its object ends in the loop: what it counts is another loop, of which the compiler has left one
//   round.
std::optional<std::uint64_t> declared_rounds(const std::vector<LoopMarker>& markers,
                                             const Flow& flow, const Graph& graph,
                                             const Loops& loops, const Loop& loop);

}  // namespace timing
