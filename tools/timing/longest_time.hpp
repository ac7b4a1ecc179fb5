// SPDX-License-Identifier: Apache-2.0
// The bound of the networks of a function: proposed by a solver, proved in integers.
#pragma once

#include <optional>

#include "tools/timing/certificate.hpp"
#include "tools/timing/network.hpp"

namespace timing {

struct LongestTime {
  enum class Kind {
    proved,
    contradiction,  // the facts leave no way to the end
    too_long,  // a number does not fit
    failed,  // the solver has found nothing
  };
  Kind kind = Kind::failed;
  Clocks clocks{};
};

LongestTime longest_time(const Networks& networks);

// Proved by the best of what is near these prices of the facts, which may be wrong: the bound is
// then larger. Nothing where a number does not fit.
std::optional<Clocks> proved_near(const Networks& networks, const LinearProgram& program,
                                  const std::vector<double>& prices_of_facts);

}  // namespace timing
