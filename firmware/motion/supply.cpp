// SPDX-License-Identifier: Apache-2.0
// The mean interval of lines, and the slow-down by the lines in stock.
#include "motion/supply.hpp"

#include <algorithm>
#include <cstdint>

namespace motion {

namespace {

constexpr int mean_shift = 3;
// The factor in eighths: three times the missing part of `enough`.
constexpr std::uint32_t one = 8;
static_assert(Supply::enough_lines == 3 * one);

}  // namespace

std::uint32_t Supply::eighths_missing(const Stock& stock) const {
  const units::Microseconds enough = std::max(enough_time, interval_ * enough_intervals);
  if (stock.lines >= enough_lines || stock.time >= enough) return 0;
  const auto all = static_cast<std::uint32_t>(enough.count());
  const auto time = static_cast<std::uint32_t>((enough - stock.time).count());
  const auto lines = static_cast<std::uint32_t>(enough_lines - stock.lines);
  return std::min(lines, time * (3 * one) / all);
}

void Supply::line_came(units::Microseconds now) {
  const units::Microseconds passed = now - last_;
  last_ = now;
  const bool paused = !heard_ || passed > longest;
  heard_ = true;
  if (paused) {
    interval_ = {};
  } else if (interval_.count() == 0) {
    interval_ = passed;
  } else {
    interval_ += units::Microseconds((passed - interval_).count() >> mean_shift);
  }
}

units::Microseconds Supply::least_time(const Stock& stock) const {
  const std::uint32_t most = stock.resting ? one : 2 * one;
  const std::uint32_t eighths = std::min(eighths_missing(stock), most);
  const auto interval = static_cast<std::uint32_t>(interval_.count());
  return std::min(units::Microseconds(interval * eighths / one), longest);
}

}  // namespace motion
