// SPDX-License-Identifier: Apache-2.0
// report.html: one file that shows a print to a person.
#pragma once

#include <string>

#include "sim/report/results.hpp"

namespace report {

std::string to_html(const Results& results, const Courses& courses);

}  // namespace report
