// SPDX-License-Identifier: Apache-2.0
// What is measured at the edges of a print: trains of 10 kHz, and distances between edges.
#pragma once

#include <algorithm>
#include <cstdlib>

#include "tests/host/spooled_print.hpp"

namespace host_test {

inline constexpr std::int64_t clock_hz = 4'000'000, train_interval = 400;  // clocks: 10 kHz

// Of an edge's text.
inline std::int64_t position_of(const Edge& edge) {
  return std::stoll(edge.what.substr(edge.what.rfind(',') + 1));
}

// All trains of X's pulses together.
struct Trains {
  std::size_t count = 0, intervals = 0;
  std::int64_t clocks = 0;
  std::int64_t least = 0, most = 0;  // clocks between two pulses
  double hertz() const {
    return static_cast<double>(clock_hz) * static_cast<double>(intervals) /
           static_cast<double>(clocks);
  }
};

// A train is each crossing of all positions from `from` to `to`, in steps, in one direction.
inline Trains trains_of(const std::vector<Edge>& edges, std::int64_t from, std::int64_t to) {
  Trains all, now;
  std::int64_t last = -1;  // cycle; -1: outside
  for (const Edge& edge : edges) {
    if (!edge.what.starts_with("x")) continue;
    const std::int64_t position = position_of(edge);
    if (position < from || position > to) {
      last = -1;
      now = {};
      continue;
    }
    if (last >= 0) {
      const std::int64_t interval = edge.cycle - last;
      now.least = now.intervals == 0 ? interval : std::min(now.least, interval);
      now.most = std::max(now.most, interval);
      now.clocks += interval;
      ++now.intervals;
    }
    last = edge.cycle;
    if (now.intervals != static_cast<std::size_t>(to - from)) continue;
    all.least = all.count == 0 ? now.least : std::min(all.least, now.least);
    all.most = std::max(all.most, now.most);
    all.intervals += now.intervals;
    all.clocks += now.clocks;
    ++all.count;
  }
  return all;
}

// How many edges have another distance from the one before than in the other print, from where X
// is beyond `begin` for the first time: between the moves of homing the firmware looks at the end
// stops, and how long that takes depends on when the lines have come.
inline std::size_t other_intervals(const std::vector<Edge>& edges, const std::vector<Edge>& other,
                                   std::int64_t begin) {
  const auto first = std::ranges::find_if(edges, [&](const Edge& edge) {
    return edge.what.starts_with("x") && position_of(edge) > begin;
  });
  std::size_t count = 0;
  for (auto i = static_cast<std::size_t>(first - edges.begin());
       i < std::min(edges.size(), other.size()); ++i) {
    const std::int64_t made = edges[i].cycle - edges[i - 1].cycle;
    if (made != other[i].cycle - other[i - 1].cycle) ++count;
  }
  return count;
}

}  // namespace host_test
