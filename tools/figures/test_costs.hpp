// SPDX-License-Identifier: Apache-2.0
// What each test of a run has cost, from the file that ctest writes (--output-junit).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace figures {

struct TestCost {
  std::string name;
  double seconds{};  // wall time, with other tests at the same time
};

// Those that were run, the most expensive first. Throws std::runtime_error where there are none.
std::vector<TestCost> test_costs_of(std::string_view junit);

// A page with the first `count` of them and what all have cost together.
std::string page_of(const std::vector<TestCost>& costs, std::size_t count);
// {"tests": how many, "seconds": of all together}
std::string json_of(const std::vector<TestCost>& costs);

}  // namespace figures
