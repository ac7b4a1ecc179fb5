// SPDX-License-Identifier: Apache-2.0
// report.json: the results under names that are kept stable.
#pragma once

#include <string>

#include "sim/report/results.hpp"

namespace report {

std::string to_json(const Results& results);

}  // namespace report
