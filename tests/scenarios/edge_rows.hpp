// SPDX-License-Identifier: Apache-2.0
// The step edges that a print left with --edges.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/scenarios/requested_moves.hpp"

namespace scenarios {

using Position = std::array<std::int64_t, axes>;

// All edges of one clock.
struct Instant {
  std::int64_t cycle{};
  Position step{};  // -1, 0, 1 per axis
};

struct Edges {
  std::vector<Instant> instants;
  Position start{};
  std::array<std::int64_t, axes> shortest_interval{};
};

// Throws what is wrong with the file.
Edges read_edges(const std::string& path);

}  // namespace scenarios
