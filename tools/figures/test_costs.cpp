// SPDX-License-Identifier: Apache-2.0
// One <testcase name="..." time="..." status="run"> after the other.
#include "tools/figures/test_costs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <regex>
#include <stdexcept>

namespace figures {

namespace {

double total(const std::vector<TestCost>& costs) {
  return std::accumulate(costs.begin(), costs.end(), 0.0,
                         [](double sum, const TestCost& cost) { return sum + cost.seconds; });
}

}  // namespace

std::vector<TestCost> test_costs_of(std::string_view junit) {
  static const std::regex testcase(
      R"re(<testcase name="([^"]*)"[^>]* time="([0-9.]+)" status="(run|fail)")re");
  std::vector<TestCost> costs;
  using Matches = std::regex_iterator<std::string_view::const_iterator>;
  for (Matches match(junit.begin(), junit.end(), testcase), last; match != last; ++match) {
    costs.push_back({(*match)[1].str(), std::stod((*match)[2].str())});
  }
  if (costs.empty()) throw std::runtime_error("no test was run");
  std::ranges::stable_sort(costs, std::greater(), &TestCost::seconds);
  return costs;
}

std::string page_of(const std::vector<TestCost>& costs, std::size_t count) {
  std::string page = fmt::format(
      "# What the tests cost\n\nWritten by `./stepfabric figures tests`, not by hand: the {} most "
      "expensive of {} tests, which take\n{:.0f} s together, by the clock while others run on the "
      "other cores.\n\n| test | seconds | of all |\n|---|---|---|\n",
      std::min(count, costs.size()), costs.size(), total(costs));
  for (std::size_t i = 0; i < std::min(count, costs.size()); ++i) {
    page += fmt::format("| `{}` | {:.0f} | {:.0f} % |\n", costs[i].name, costs[i].seconds,
                        100 * costs[i].seconds / std::max(total(costs), 1e-9));
  }
  return page;
}

std::string json_of(const std::vector<TestCost>& costs) {
  return nlohmann::json{{"tests", costs.size()}, {"seconds", total(costs)}}.dump(2) + "\n";
}

}  // namespace figures
