// SPDX-License-Identifier: Apache-2.0
// An evolutionary search for the inputs that make the tasks of the main loop take long.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tools/worst_inputs/breeder.hpp"
#include "tools/worst_inputs/rig.hpp"

namespace worst_inputs {

struct Found {
  std::uint32_t clocks{};
  std::size_t start{};
  SerialInput input;
};

// Each start has its own population. Each generation is of one start, in turn.
class Search {
 public:
  // Of several inputs behind a start, in their order.
  using Measure =
      std::function<std::vector<Slices>(std::size_t start, const std::vector<SerialInput>&)>;

  // Behind each start the first inputs are those given, in their order.
  Search(std::uint64_t seed, std::size_t starts, Measure measure,
         std::vector<SerialInput> first = {})
      : breeder_(seed),
        measure_(std::move(measure)),
        first_(std::move(first)),
        populations_(starts) {}

  // A generation of so many inputs, bred of those before: what is found depends on their number.
  void step(std::size_t inputs);

  // All that it knows, and that again: it goes on as if it had not been stopped. Throws
  // std::runtime_error where that is none, or of another number of starts.
  std::string state() const;
  void resume(const std::string& state);

  std::uint64_t inputs() const { return inputs_; }
  // The worst one of a task, or of the pass, behind all starts; after the first step.
  const Found& worst(std::size_t place) const;
  // Behind this start; after its first step.
  const Found& worst(std::size_t place, std::size_t start) const {
    return populations_.at(start).pools.at(place).front();
  }

 private:
  // The worst of a task, the longest first.
  using Pool = std::vector<Found>;
  struct Population {
    std::size_t inputs{};
    std::array<Pool, std::tuple_size_v<Slices>> pools;
  };

  SerialInput child(const Population& population);
  void keep(std::size_t start, const SerialInput& input, const Slices& slices);

  Breeder breeder_;
  Measure measure_;
  std::vector<SerialInput> first_;
  std::vector<Population> populations_;
  std::size_t next_ = 0;  // start
  std::uint64_t inputs_ = 0;
};

}  // namespace worst_inputs
