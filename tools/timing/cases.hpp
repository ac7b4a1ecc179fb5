// SPDX-License-Identifier: Apache-2.0
// Cases of a linear program, where an event that happens at most once is divided.
#pragma once

#include <vector>

#include "tools/timing/network.hpp"

namespace timing {

// A solution may pass one place of the event half a time, and another one too: a mean of a path
// with both and of one with neither, which is longer than any path. A path that keeps to the fact
// leaves out the one place or all others: each path is one of a case. An arc on which it happens
// twice is on no such path: it is left out, and there is one case. `passes` is the solution, by
// arc. Nothing where no event that surely happens at most once is divided.
std::vector<Networks> cases_of(const Networks& networks, const std::vector<double>& passes);

}  // namespace timing
