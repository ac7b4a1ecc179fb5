// SPDX-License-Identifier: Apache-2.0
// Why a function has no bound: where, and what to do about it.
#pragma once

#include <compare>
#include <stdexcept>
#include <string>
#include <utility>

namespace timing {

struct Problem {
  std::string place;
  std::string function;
  std::string what;
  std::string remedy;
  auto operator<=>(const Problem&) const = default;
};

// "FILE:LINE: in FUNCTION: WHAT: REMEDY".
inline std::string to_text(const Problem& problem) {
  return problem.place + ": in " + problem.function + ": " + problem.what + ": " + problem.remedy;
}

class Unbounded : public std::runtime_error {
 public:
  explicit Unbounded(Problem problem)
      : std::runtime_error(to_text(problem)), problem_(std::move(problem)) {}
  const Problem& problem() const { return problem_; }

 private:
  Problem problem_;
};

}  // namespace timing
