// SPDX-License-Identifier: Apache-2.0
// A plan for a person, and for a program.
#pragma once

#include <string>

#include "tools/planning/plan.hpp"

namespace planning {

std::string to_text(const Plan& plan);
std::string to_json(const Plan& plan);

}  // namespace planning
