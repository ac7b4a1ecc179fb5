// SPDX-License-Identifier: Apache-2.0
// Scores and decisions of a campaign.
#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <set>

#include "tools/proof/campaign.hpp"

namespace proof {

const char* name_of(Fate fate) {
  switch (fate) {
    case Fate::killed:
      return "killed";
    case Fate::refused:
      return "refused";
    case Fate::proved_equivalent:
      return "proved equivalent";
    case Fate::judged_equivalent:
      return "judged equivalent";
    case Fate::surviving:
      return "surviving";
  }
  return "";
}

Count count(const std::vector<MutantOutcome>& outcomes, const std::string& unit) {
  Count count;
  for (const MutantOutcome& outcome : outcomes) {
    if (!unit.empty() && outcome.unit != unit) continue;
    switch (outcome.fate) {
      case Fate::killed:
        ++count.killed;
        break;
      case Fate::refused:
        ++count.refused;
        break;
      case Fate::proved_equivalent:
        ++count.proved_equivalent;
        break;
      case Fate::judged_equivalent:
        ++count.judged_equivalent;
        break;
      case Fate::surviving:
        ++count.surviving;
        break;
    }
  }
  return count;
}

std::vector<std::size_t> sample_of(std::size_t all, std::size_t wanted, std::uint64_t seed) {
  std::vector<std::size_t> numbers(all);
  for (std::size_t i = 0; i < all; ++i) numbers[i] = i;
  if (wanted == 0 || wanted >= all) return numbers;
  // Not std::shuffle: its choice is not the same with every library.
  std::mt19937_64 random(seed);
  for (std::size_t i = 0; i < wanted; ++i) std::swap(numbers[i], numbers[i + random() % (all - i)]);
  numbers.resize(wanted);
  std::ranges::sort(numbers);
  return numbers;
}

std::vector<std::string> stale_entries(const std::map<std::string, Judgement>& judgements,
                                       const std::vector<std::string>& made,
                                       const std::vector<MutantOutcome>& outcomes) {
  std::vector<std::string> stale;
  const std::set<std::string> known(made.begin(), made.end());
  for (const auto& [id, judgement] : judgements) {
    if (!known.contains(id)) stale.push_back(fmt::format("no such mutant is made: {}", id));
  }
  for (const MutantOutcome& outcome : outcomes) {
    // A proof of equivalence refutes no judgement, and whether it ends in time depends on
    // the machine.
    const bool is_refuted = outcome.fate == Fate::killed || outcome.fate == Fate::refused;
    if (judgements.contains(outcome.mutant.id) && is_refuted) {
      stale.push_back(
          fmt::format("is {} ({}): {}", name_of(outcome.fate), outcome.by, outcome.mutant.id));
    }
  }
  return stale;
}

bool is_good(const std::vector<MutantOutcome>& outcomes, const std::vector<std::string>& stale,
             bool is_sample) {
  constexpr double wanted_score = 0.97;
  const bool all_are_listed = std::ranges::all_of(outcomes, [](const MutantOutcome& outcome) {
    return outcome.fate != Fate::surviving || outcome.is_listed;
  });
  return stale.empty() && all_are_listed && (is_sample || count(outcomes).score() >= wanted_score);
}

}  // namespace proof
