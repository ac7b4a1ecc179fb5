// SPDX-License-Identifier: Apache-2.0
// The report's pictures as SVG, drawn by gnuplot.
#pragma once

#include <string>

#include "sim/report/results.hpp"

namespace report {

// Each returns one <svg> element. Throws std::runtime_error where gnuplot is missing or fails.
std::string plot_path_from_above(const Courses& courses);
std::string plot_path_in_space(const Courses& courses);
std::string plot_temperatures(const Courses& courses);
std::string plot_step_rates(const Courses& courses);
std::string plot_step_intervals(const Courses& courses);

}  // namespace report
