// SPDX-License-Identifier: Apache-2.0
// An evolutionary search for the inputs that make the tasks of the main loop take long.
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "tools/worst_inputs/breeder.hpp"
#include "tools/worst_inputs/rig.hpp"

namespace worst_inputs {

struct Found {
  std::uint32_t clocks{};
  SerialInput input;
};

class Search {
 public:
  using Measure = std::function<Slices(const SerialInput&)>;

  Search(std::uint64_t seed, Measure measure) : breeder_(seed), measure_(std::move(measure)) {}

  // One more input.
  void step();

  std::uint64_t inputs() const { return inputs_; }
  // The worst one of a task; empty before the first step.
  const Found& worst(std::size_t task) const { return pools_.at(task).front(); }

 private:
  SerialInput child();
  void keep(const SerialInput& input, const Slices& slices);

  Breeder breeder_;
  Measure measure_;
  std::uint64_t inputs_ = 0;
  // The worst of each task, the longest first.
  std::array<std::vector<Found>, units::task_count> pools_;
};

}  // namespace worst_inputs
