// SPDX-License-Identifier: Apache-2.0
// The longest time as a linear program over how often each arc is passed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "tools/timing/network.hpp"

namespace timing {

struct Constraint {
  bool is_equation = true;  // otherwise: at most
  std::int64_t right_side{};
};

struct Column {
  std::int64_t clocks{};
  std::vector<std::pair<std::size_t, std::int64_t>> entries;  // row and factor; each row once
};

// Most clocks of all columns that are 0 or more and keep to the rows.
struct LinearProgram {
  std::vector<Constraint> rows;
  std::vector<Column> columns;
};

// Where the rows of the networks lie: of each node, of each loop, of each fact.
struct RowNumbers {
  explicit RowNumbers(const Networks& networks);

  std::size_t node(std::size_t network, std::size_t node) const { return nodes[network] + node; }
  std::size_t loop(std::size_t network, std::size_t loop) const { return loops[network] + loop; }
  std::size_t fact(std::size_t fact) const { return facts + fact; }

  std::vector<std::size_t> nodes, loops;  // first row of each network
  std::size_t facts{}, count{};
};

// The first network is passed once, the others as often as they are called.
// - Each node is left as often as it is reached.
// - Each loop goes back to its header at most `most` times as often as it is entered.
// - Each fact's events happen at most `most` times as often as its runs begin.
// The solution without fractions is the integer program of implicit path enumeration (Li and Malik,
// "Performance Analysis of Embedded Software Using Implicit Path Enumeration", 1995).
LinearProgram program_of(const Networks& networks);

}  // namespace timing
