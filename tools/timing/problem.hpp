// SPDX-License-Identifier: Apache-2.0
// Why a function has no bound: where, and what to do about it.
#pragma once

#include <compare>
#include <stdexcept>
#include <string>

namespace timing {

struct Problem {
  std::string place;
  std::string function;
  std::string what;
  std::string remedy;
  auto operator<=>(const Problem&) const = default;
};

class Unbounded : public std::runtime_error {
 public:
  explicit Unbounded(Problem problem)
      : std::runtime_error(problem.what), problem_(std::move(problem)) {}
  const Problem& problem() const { return problem_; }

 private:
  Problem problem_;
};

}  // namespace timing
