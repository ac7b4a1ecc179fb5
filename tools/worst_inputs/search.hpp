// SPDX-License-Identifier: Apache-2.0
// An evolutionary search for the inputs that make the tasks of the main loop take long.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <tuple>
#include <utility>
#include <vector>

#include "tools/worst_inputs/breeder.hpp"
#include "tools/worst_inputs/rig.hpp"

namespace worst_inputs {

struct Found {
  std::uint32_t clocks{};
  SerialInput input;
};

class Search {
 public:
  // Of several inputs, in their order.
  using Measure = std::function<std::vector<Slices>(const std::vector<SerialInput>&)>;

  // The first inputs are those given, in their order.
  Search(std::uint64_t seed, Measure measure, std::vector<SerialInput> first = {})
      : breeder_(seed), measure_(std::move(measure)), first_(std::move(first)) {}

  // So many inputs more, bred of those before: what is found depends on their number.
  void step(std::size_t inputs);

  std::uint64_t inputs() const { return inputs_; }
  // The worst one of a task, or of the pass; empty before the first step.
  const Found& worst(std::size_t place) const { return pools_.at(place).front(); }

 private:
  SerialInput child();
  void keep(const SerialInput& input, const Slices& slices);

  Breeder breeder_;
  Measure measure_;
  std::vector<SerialInput> first_;
  std::uint64_t inputs_ = 0;
  // The worst of each task and of the pass, the longest first.
  std::array<std::vector<Found>, std::tuple_size_v<Slices>> pools_;
};

}  // namespace worst_inputs
