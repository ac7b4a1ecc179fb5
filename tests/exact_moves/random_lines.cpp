// SPDX-License-Identifier: Apache-2.0
// Sizes are log-uniform, decimals from none to nine.
#include "tests/exact_moves/random_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace exact_moves {

namespace {

constexpr double smallest_mm = 1e-8;
constexpr double least_arc_mm = 1e-4;  // smaller ones have no radius
constexpr double mm_per_inch = 25.4;
// With the flow: more than 200 mm are prevented, and rounding to whole inches may add 127 mm.
constexpr double largest_extrusion_mm = 70;

}  // namespace

double RandomLines::size_mm(const ExactAxes& axes, std::size_t axis) {
  double largest = largest_mm_;
  if (axis == 3) {
    const double flow = static_cast<double>(axes.flow_percent()) / 100;
    largest = std::min(largest, largest_extrusion_mm / flow);
  }
  const double part = static_cast<double>(below(1'000'000)) * 1e-6;
  const double size = smallest_mm * std::pow(largest / smallest_mm, part);
  return below(2) != 0 ? size : -size;
}

std::string RandomLines::coordinates(const ExactAxes& axes, std::string line, bool far) {
  constexpr std::string_view letters = "XYZE";
  for (std::size_t i = 0; i < axis_count; ++i) {
    if (below(2) != 0) continue;
    const double from = far ? 0.0 : axes.relative(i) ? 0.0 : axes.logical_mm(i);
    const double value = (from + size_mm(axes, i)) / (axes.inches() ? mm_per_inch : 1.0);
    // Mostly what resolves the size, sometimes what a slicer writes.
    const int decimals = below(3) != 0 ? 9 : static_cast<int>(below(7));
    line += fmt::format(" {}{:.{}f}", letters[i], value, decimals);
  }
  return line;
}

std::string RandomLines::move(const ExactAxes& axes) {
  std::string line = coordinates(axes, below(2) != 0 ? "G1" : "G0", false);
  if (below(4) == 0) {
    line += fmt::format(" F{}", axes.inches() ? 30 + below(300) : 600 + below(9000));
  }
  return line;
}

// Half a circle about the middle between its ends: with all decimals, so that these are on it.
std::string RandomLines::arc(const ExactAxes& axes) {
  std::string line = below(2) != 0 ? "G2" : "G3";
  const double unit = axes.inches() ? mm_per_inch : 1.0;
  for (std::size_t i = 0; i < axis_count; ++i) {
    const double size = size_mm(axes, i);
    const double way = std::copysign(std::max(std::abs(size), least_arc_mm), size);
    const double from = axes.relative(i) ? 0.0 : axes.logical_mm(i);
    line += fmt::format(" {}{:.9f}", "XYZE"[i], (from + way) / unit);
    if (i < 2) line += fmt::format(" {}{:.9f}", "IJ"[i], way / 2 / unit);
  }
  return line;
}

std::string RandomLines::next(const ExactAxes& axes) {
  switch (below(32)) {
    case 0:
      return "G90";
    case 1:
      return "G91";
    case 2:
      return "M82";
    case 3:
      return "M83";
    case 4:
      return "G20";
    case 5:
      return "G21";
    case 6:
      return coordinates(axes, "G92", true);
    case 7:
      return fmt::format("M221 S{}", below(2) != 0 ? 100 : 1 + below(999));
    case 8:
      return arc(axes);
    default:
      return move(axes);
  }
}

}  // namespace exact_moves
