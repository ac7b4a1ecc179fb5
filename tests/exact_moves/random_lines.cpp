// SPDX-License-Identifier: Apache-2.0
// Sizes are log-uniform, decimals from none to nine.
#include "tests/exact_moves/random_lines.hpp"

#include <fmt/format.h>

#include <cmath>

namespace exact_moves {

namespace {

constexpr double smallest_mm = 1e-8;
constexpr double mm_per_inch = 25.4;

}  // namespace

double RandomLines::size_mm() {
  const double part = static_cast<double>(below(1'000'000)) * 1e-6;
  const double size = smallest_mm * std::pow(largest_mm_ / smallest_mm, part);
  return below(2) != 0 ? size : -size;
}

std::string RandomLines::coordinates(const ExactAxes& axes, std::string line, bool far) {
  constexpr std::string_view letters = "XYZE";
  for (std::size_t i = 0; i < axis_count; ++i) {
    if (below(2) != 0) continue;
    const double from = far ? 0.0 : axes.relative(i) ? 0.0 : axes.logical_mm(i);
    const double value = (from + size_mm()) / (axes.inches() ? mm_per_inch : 1.0);
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

std::string RandomLines::next(const ExactAxes& axes) {
  switch (below(24)) {
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
    default:
      return move(axes);
  }
}

}  // namespace exact_moves
