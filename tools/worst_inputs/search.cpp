// SPDX-License-Identifier: Apache-2.0
#include "tools/worst_inputs/search.hpp"

#include <algorithm>

namespace worst_inputs {

namespace {

constexpr std::size_t pool_size = 24;
// One in so many inputs owes nothing to those before, and one in so many children has two parents.
constexpr std::size_t new_in = 8, crossed_in = 5;

}  // namespace

SerialInput Search::child() {
  if (inputs_ < first_.size()) return first_[inputs_];
  const auto& pool = pools_[breeder_.below(pools_.size())];
  if (pool.empty() || breeder_.one_in(new_in)) return breeder_.random();
  // The better half twice as often.
  const auto parent = [&]() -> const SerialInput& {
    return pool[std::min(breeder_.below(pool.size()), breeder_.below(pool.size()))].input;
  };
  if (breeder_.one_in(crossed_in)) return breeder_.crossed(parent(), parent());
  return breeder_.changed(parent());
}

void Search::keep(const SerialInput& input, const Slices& slices) {
  for (std::size_t task = 0; task < pools_.size(); ++task) {
    auto& pool = pools_[task];
    const std::uint32_t clocks = slices[task];
    const auto place =
        std::ranges::find_if(pool, [&](const Found& found) { return found.clocks <= clocks; });
    // One of each time: the pool would fill with copies of the worst.
    if (place != pool.end() && place->clocks == clocks) {
      place->input = input;
      continue;
    }
    if (place == pool.end() && pool.size() == pool_size) continue;
    pool.insert(place, {.clocks = clocks, .input = input});
    if (pool.size() > pool_size) pool.pop_back();
  }
}

void Search::step(std::size_t inputs) {
  std::vector<SerialInput> children;
  for (; children.size() < inputs; ++inputs_) children.push_back(child());
  const std::vector<Slices> slices = measure_(children);
  for (std::size_t i = 0; i < children.size(); ++i) keep(children[i], slices.at(i));
}

}  // namespace worst_inputs
