// SPDX-License-Identifier: Apache-2.0
// The mean interval of lines, and the stretch by stock, without a division.
#include "motion/supply.hpp"

#include <algorithm>
#include <cstdint>

namespace motion {

namespace {

constexpr int mean_shift = 3;
// The factor in eighths: three times the missing part of `enough`.
constexpr std::uint32_t one = 8;
static_assert(Supply::enough_lines == 3 * one);
// 24 eighths of 100 000 us: 1 for 2^12 us, which is 24.4 for all of it.
constexpr int time_shift = 12;
static_assert((Supply::enough_time.count() >> time_shift) == 3 * one);

std::uint32_t eighths_missing(const Stock& stock) {
  if (stock.lines >= Supply::enough_lines || stock.time >= Supply::enough_time) return 0;
  const auto time = static_cast<std::uint32_t>((Supply::enough_time - stock.time).count());
  const auto lines = static_cast<std::uint32_t>(Supply::enough_lines - stock.lines);
  return std::min(lines, time >> time_shift);
}

}  // namespace

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
