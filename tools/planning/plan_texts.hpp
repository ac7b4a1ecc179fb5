// SPDX-License-Identifier: Apache-2.0
// A plan for a person, and for a program.
#pragma once

#include <cstddef>
#include <limits>
#include <string>

#include "tools/planning/plan.hpp"

namespace planning {

// At most so many are listed; how many there are is said in any case.
struct ListLimits {
  std::size_t refused = std::numeric_limits<std::size_t>::max();  // lines, of each 256 bytes
  std::size_t layers = std::numeric_limits<std::size_t>::max();
};

std::string to_text(const Plan& plan, const ListLimits& limits = {});
std::string to_json(const Plan& plan, const ListLimits& limits = {});

}  // namespace planning
