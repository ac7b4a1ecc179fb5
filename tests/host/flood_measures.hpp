// SPDX-License-Identifier: Apache-2.0
// What is measured at the edges of a print: trains of 10 kHz, and distances between edges.
#pragma once

#include <algorithm>
#include <cstdlib>

#include "tests/host/spooled_print.hpp"

namespace host_test {

inline constexpr std::int64_t clock_hz = 4'000'000, train_interval = 400;  // clocks: 10 kHz

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

// A train is what is at least a second of intervals within a tenth of the wanted one.
inline Trains trains_of(const std::vector<Edge>& edges) {
  constexpr std::int64_t tolerance = train_interval / 10;
  constexpr std::size_t shortest = 10'000;
  Trains all, now;
  const auto end_train = [&] {
    if (now.intervals >= shortest) {
      all.least = all.count == 0 ? now.least : std::min(all.least, now.least);
      all.most = std::max(all.most, now.most);
      all.intervals += now.intervals;
      all.clocks += now.clocks;
      ++all.count;
    }
    now = {};
  };
  std::int64_t last = 0;
  for (const Edge& edge : edges) {
    if (!edge.what.starts_with("x")) continue;
    const std::int64_t interval = edge.cycle - last;
    last = edge.cycle;
    if (std::abs(interval - train_interval) > tolerance) {
      end_train();
      continue;
    }
    now.least = now.intervals == 0 ? interval : std::min(now.least, interval);
    now.most = std::max(now.most, interval);
    now.clocks += interval;
    ++now.intervals;
  }
  end_train();
  return all;
}

// How many edges have another distance from the one before than in the other print.
inline std::size_t other_intervals(const std::vector<Edge>& edges, const std::vector<Edge>& other) {
  std::size_t count = 0;
  for (std::size_t i = 1; i < std::min(edges.size(), other.size()); ++i) {
    const std::int64_t made = edges[i].cycle - edges[i - 1].cycle;
    if (made != other[i].cycle - other[i - 1].cycle) ++count;
  }
  return count;
}

}  // namespace host_test
