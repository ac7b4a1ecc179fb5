// SPDX-License-Identifier: Apache-2.0
// The numbers behind the pictures of report.html, as JSON that its scripts read.
#pragma once

#include <string>

#include "sim/report/results.hpp"

namespace report {

// Lengths in µm, times in ms, each as the difference to the value before it; page/data.js unpacks
// them. Without any `<`, so that it can stand in a page.
std::string page_data(const Results& results, const Courses& courses);

// What is wrong at a missed point, in words: a line for each axis.
std::string words_of(const MissedPoint& point);

// When the chip refused this line of the file, and where the nozzle should have gone; empty if the
// line is not known.
struct RefusalPlace {
  bool known{};
  double seconds{};
  bool moves{};
  std::array<float, 3> from{}, to{};  // where it moves
};
RefusalPlace place_of(const RefusedLine& line, const Results& results, const Courses& courses);

}  // namespace report
