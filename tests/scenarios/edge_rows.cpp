// SPDX-License-Identifier: Apache-2.0
// Reads rows of cycle, axis, direction and position.
#include "tests/scenarios/edge_rows.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string_view>

namespace scenarios {

Edges read_edges(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line) || line != "cycle,axis,direction,position") {
    throw std::runtime_error(path + ": not an edges file");
  }
  Edges edges;
  edges.shortest_interval.fill(INT64_MAX);
  std::array<std::int64_t, axes> last_cycle{};
  std::array<bool, axes> seen{};
  Position position{};
  while (std::getline(file, line)) {
    std::int64_t cycle = 0;
    char letter = 0;
    std::int64_t direction = 0;
    std::int64_t place = 0;
    if (std::sscanf(line.c_str(), "%ld,%c,%ld,%ld", &cycle, &letter, &direction, &place) != 4) {
      throw std::runtime_error(path + ": bad row: " + line);
    }
    const std::size_t axis = std::string_view("xyze").find(letter);
    if (axis >= axes) throw std::runtime_error(path + ": unknown axis: " + line);
    if (!seen[axis]) {
      edges.start[axis] = position[axis] = place - direction;
      seen[axis] = true;
    } else {
      edges.shortest_interval[axis] =
          std::min(edges.shortest_interval[axis], cycle - last_cycle[axis]);
    }
    if (position[axis] + direction != place) {
      throw std::runtime_error(path + ": a step was lost: " + line);
    }
    position[axis] = place;
    last_cycle[axis] = cycle;
    if (edges.instants.empty() || edges.instants.back().cycle != cycle) {
      if (!edges.instants.empty() && edges.instants.back().cycle > cycle) {
        throw std::runtime_error(path + ": not in order of time: " + line);
      }
      edges.instants.push_back({cycle, {}});
    }
    edges.instants.back().step[axis] += direction;
  }
  return edges;
}

}  // namespace scenarios
