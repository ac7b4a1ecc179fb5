// SPDX-License-Identifier: Apache-2.0
// Random G-code: moves of 0.01 nm to `largest_mm` and arcs, absolute and relative, in millimetres
// and inches, and the commands that change origin or scale.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "tests/exact_moves/exact_axes.hpp"

namespace exact_moves {

class RandomLines {
 public:
  RandomLines(std::uint64_t seed, double largest_mm) : random_(seed), largest_mm_(largest_mm) {}

  // A line that goes on from where `axes` are.
  std::string next(const ExactAxes& axes);

 private:
  std::string move(const ExactAxes& axes);
  std::string arc(const ExactAxes& axes);
  std::string coordinates(const ExactAxes& axes, std::string line, bool far);
  std::uint64_t below(std::uint64_t limit) { return random_() % limit; }
  double size_mm(const ExactAxes& axes, std::size_t axis);

  std::mt19937_64 random_;
  double largest_mm_;
};

}  // namespace exact_moves
