// SPDX-License-Identifier: Apache-2.0
// Without facts the longest way is the optimum, and no solver is needed.
#include "tools/timing/longest_time.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "tools/timing/cases.hpp"
#include "tools/timing/pricing.hpp"
#include "tools/timing/solver.hpp"

namespace timing {

namespace {

// Prices of an optimum are quotients of small numbers: 720 720 is a multiple of 1 to 16.
constexpr std::int64_t scales[] = {1, 720'720};

// Each makes two programs of one.
constexpr unsigned most_distinctions = 8;

Wide rounded(double price, std::int64_t scale) {
  constexpr double most = 1e18;
  // Also of what is no number.
  if (!(price > 0)) return 0;
  return static_cast<Wide>(std::llround(std::min(price * static_cast<double>(scale), most)));
}

}  // namespace

std::optional<Clocks> proved_near(const Networks& networks, const LinearProgram& program,
                                  const std::vector<double>& prices_of_facts) {
  std::optional<Clocks> least;
  for (const std::int64_t scale : scales) {
    std::vector<Wide> of_facts;
    for (const double one : prices_of_facts) of_facts.push_back(rounded(one, scale));
    try {
      const auto bound = proved_bound(program, price(networks, scale, of_facts));
      if (bound) least = std::min(least.value_or(*bound), *bound);
    } catch (const std::overflow_error&) {
      // Another scale may do.
    }
  }
  return least;
}

namespace {

LongestTime with_cases(const Networks& networks, unsigned distinctions);

// The longest of all cases. Nothing where there are none, or one is not proved: that it has no
// path, for example, the solver only says.
std::optional<LongestTime> longest(const std::vector<Networks>& cases, unsigned distinctions) {
  std::optional<LongestTime> longest;
  for (const Networks& networks : cases) {
    const LongestTime found = with_cases(networks, distinctions);
    if (found.kind != LongestTime::Kind::proved) return std::nullopt;
    if (!longest || found.clocks > longest->clocks) longest = found;
  }
  return longest;
}

// So many distinctions, one in the other.
LongestTime with_cases(const Networks& networks, unsigned distinctions) {
  using Kind = LongestTime::Kind;
  const LinearProgram program = program_of(networks);
  std::vector<double> of_facts(networks.facts.size());
  if (!networks.facts.empty()) {
    const Solution solution = solve(program);
    if (solution.kind == Solution::Kind::infeasible) return {.kind = Kind::contradiction};
    if (solution.kind == Solution::Kind::failed) return {.kind = Kind::failed};
    if (distinctions != 0) {
      const auto found = longest(cases_of(networks, solution.passes), distinctions - 1);
      if (found) return *found;
    }
    const std::size_t first = RowNumbers(networks).fact(0);
    std::copy_n(solution.prices.begin() + static_cast<std::ptrdiff_t>(first), of_facts.size(),
                of_facts.begin());
  }
  const auto clocks = proved_near(networks, program, of_facts);
  if (!clocks) return {.kind = Kind::too_long};
  return {.kind = Kind::proved, .clocks = *clocks};
}

}  // namespace

LongestTime longest_time(const Networks& networks) {
  return with_cases(networks, most_distinctions);
}

}  // namespace timing
