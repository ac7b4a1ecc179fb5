// SPDX-License-Identifier: Apache-2.0
// Whether a print is good, and sentences that explain why not.
#pragma once

#include "sim/report/results.hpp"

namespace report {

// Fills in `findings.problems` from everything else in the results.
void judge(Results& results);

// "good" or "bad".
constexpr const char* verdict_of(const Results& results) { return results.good() ? "good" : "bad"; }

}  // namespace report
