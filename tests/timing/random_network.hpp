// SPDX-License-Identifier: Apache-2.0
// Random programs of sequences, choices and loops, with their longest times found by trying all.
#pragma once

#include <map>
#include <random>

#include "tools/timing/network.hpp"

namespace timing {

// How often each of two events happens, and the longest time with so many.
using Times = std::map<std::pair<Clocks, Clocks>, Clocks>;

struct RandomNetwork {
  Networks networks;
  Times times;  // of all paths, without the facts

  // Of the paths that keep to the facts; 0 if there is none.
  Clocks longest() const;
  bool has_path() const;
};

// With two facts, each of the whole run.
RandomNetwork random_network(std::mt19937& random);

}  // namespace timing
