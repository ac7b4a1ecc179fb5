// SPDX-License-Identifier: Apache-2.0
#include "tools/worst_inputs/search.hpp"

#include <algorithm>
#include <stdexcept>

namespace worst_inputs {

namespace {

constexpr std::size_t pool_size = 24;
// One in so many inputs owes nothing to those before; one in so many children has a parent behind
// another start, and one in so many has two parents.
constexpr std::size_t new_in = 8, from_elsewhere_in = 8, crossed_in = 5;

}  // namespace

SerialInput Search::child(const Population& own) {
  if (own.inputs < first_.size()) return first_[own.inputs];
  const Population& population =
      breeder_.one_in(from_elsewhere_in) ? populations_[breeder_.below(populations_.size())] : own;
  const Pool& pool = population.pools[breeder_.below(population.pools.size())];
  if (pool.empty() || breeder_.one_in(new_in)) return breeder_.random();
  // The better half twice as often.
  const auto parent = [&]() -> const SerialInput& {
    return pool[std::min(breeder_.below(pool.size()), breeder_.below(pool.size()))].input;
  };
  if (breeder_.one_in(crossed_in)) return breeder_.crossed(parent(), parent());
  return breeder_.changed(parent());
}

void Search::keep(std::size_t start, const SerialInput& input, const Slices& slices) {
  for (std::size_t task = 0; task < slices.size(); ++task) {
    Pool& pool = populations_[start].pools[task];
    const std::uint32_t clocks = slices[task];
    const auto place =
        std::ranges::find_if(pool, [&](const Found& found) { return found.clocks <= clocks; });
    // One of each time, the shortest: the pool would fill with copies of the worst.
    if (place != pool.end() && place->clocks == clocks) {
      if (bytes_of(input) <= bytes_of(place->input)) place->input = input;
      continue;
    }
    if (place == pool.end() && pool.size() == pool_size) continue;
    pool.insert(place, {.clocks = clocks, .start = start, .input = input});
    if (pool.size() > pool_size) pool.pop_back();
  }
}

void Search::step(std::size_t inputs) {
  const std::size_t start = next_;
  next_ = (next_ + 1) % populations_.size();
  Population& population = populations_[start];
  std::vector<SerialInput> children;
  for (; children.size() < inputs; ++population.inputs) children.push_back(child(population));
  inputs_ += inputs;
  const std::vector<Slices> slices = measure_(start, children);
  for (std::size_t i = 0; i < children.size(); ++i) keep(start, children[i], slices.at(i));
}

const Found& Search::worst(std::size_t place) const {
  const Found* worst = nullptr;
  for (const Population& population : populations_) {
    const Pool& pool = population.pools.at(place);
    if (pool.empty()) continue;
    if (worst == nullptr || pool.front().clocks > worst->clocks) worst = &pool.front();
  }
  if (worst == nullptr) throw std::logic_error("nothing is measured yet");
  return *worst;
}

}  // namespace worst_inputs
