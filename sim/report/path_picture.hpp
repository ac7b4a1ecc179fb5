// SPDX-License-Identifier: Apache-2.0
// The path from above as one SVG, for readers without scripts.
#pragma once

#include <string>

#include "sim/report/results.hpp"

namespace report {

// Asked lines under the lines as printed, missed points on top. Colours are classes of the page.
std::string path_picture(const Results& results, const Courses& courses);

}  // namespace report
