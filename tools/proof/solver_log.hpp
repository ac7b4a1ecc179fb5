// SPDX-License-Identifier: Apache-2.0
// What yosys-smtbmc says.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace proof {

struct SolverLog {
  // Nothing where it did not come to an end.
  std::optional<bool> holds;
  // Labels with their instances, where it does not hold.
  std::vector<std::string> failed;
  // Clock after the start (or of the induction) at which they failed.
  int failed_at{};
};

SolverLog read_solver_log(std::string_view text);

// What Yosys' solver reports of the solutions that it found, each as the values that the signals
// have in its last clock, one text for all of them; without the one in which all are zero.
std::set<std::string> read_solutions(std::string_view text);

}  // namespace proof
