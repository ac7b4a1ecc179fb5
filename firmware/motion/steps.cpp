// SPDX-License-Identifier: Apache-2.0
// Exact conversion of positions, with 32-bit divisions where it is done for every move.
#include "motion/steps.hpp"

#include "motion/limits.hpp"
#include "units/magnitude.hpp"

namespace motion {

namespace {

constexpr std::uint64_t nanometers_per_meter = 1'000'000'000;

struct Quotient {
  std::uint64_t whole;
  std::uint32_t rest;  // in 2^9
};

constexpr auto divisor = static_cast<std::uint32_t>(one_step.count());
static_assert(std::uint64_t{divisor} << 9 == nanometers_per_meter);

// value / divisor, and `value` becomes the rest.
std::uint32_t take_quotient(std::uint32_t& value) {
  // 2^52 / divisor, rounded down, less by 0.21: the estimate is at most 1 too small.
  constexpr std::uint32_t reciprocal = (std::uint64_t{1} << 52) / divisor;
  auto quotient = static_cast<std::uint32_t>(std::uint64_t{value} * reciprocal >> 52);
  value -= quotient * divisor;
  if (value >= divisor) {
    value -= divisor;
    ++quotient;
  }
  return quotient;
}

// value / 10^9 for value < 2^63: 10^9 is 2^9 * 1 953 125, and the latter has 21 bits, so that three
// 32-bit quotients of 32, 11 and 11 new bits suffice. Without divisions, which take long.
Quotient divide_by_billion(std::uint64_t value) {
  const auto lower = static_cast<std::uint32_t>(value >> 9) & 0x3F'FFFF;
  auto rest = static_cast<std::uint32_t>(value >> 31);
  const std::uint32_t first = rest < divisor ? 0 : take_quotient(rest);
  rest = rest << 11 | lower >> 11;
  const std::uint32_t second = take_quotient(rest);
  rest = rest << 11 | (lower & 0x7FF);
  const std::uint32_t third = take_quotient(rest);
  return {(std::uint64_t{first} << 22) + (second << 11) + third, rest};
}

std::int64_t with_sign_of(std::int64_t sign, std::uint64_t value) {
  const auto count = static_cast<std::int64_t>(value);
  return sign < 0 ? -count : count;
}

}  // namespace

StepPosition steps_at(const units::Position& position, units::StepsPerMeter steps_per_meter) {
  constexpr std::uint64_t product_fits = (std::uint64_t{1} << 63) / 10'000'001;
  static_assert(max_steps_per_meter.count() < 10'000'001);
  const auto factor = static_cast<std::uint32_t>(steps_per_meter.count());
  const bool negative = position.whole() < units::Nanometers();
  const units::Position size = negative ? -position : position;
  auto distance = static_cast<std::uint64_t>(size.whole().count());
  std::uint64_t steps = 0;
  if (distance > product_fits) {
    const std::uint64_t meters = divide_by_billion(distance).whole;
    distance -= meters * nanometers_per_meter;
    steps = meters * factor;
  }
  std::uint64_t parts = distance * factor + nanometers_per_meter / 2;  // 10^-9 of a step
  if (size.femtometers() != 0) {
    // What is below such a part decides nothing: halves of a step are whole numbers of parts.
    constexpr std::uint32_t billionths = 1'000'000'000 / units::Position::femtometers_per_nanometer;
    const auto above = static_cast<std::uint32_t>(size.femtometers()) * billionths;
    parts += divide_by_billion(std::uint64_t{above} * factor).whole;
  }
  const Quotient rounded = divide_by_billion(parts);
  const std::int32_t residual = static_cast<std::int32_t>(rounded.rest) - one_step.count() / 2;
  const auto count = static_cast<std::int64_t>(steps + rounded.whole);
  return {.steps = negative ? -count : count,
          .residual = StepParts(negative ? -residual : residual)};
}

units::Nanometers position_of(std::int64_t steps, units::StepsPerMeter steps_per_meter) {
  const auto per_meter = static_cast<std::uint32_t>(steps_per_meter.count());
  if (per_meter == 0) return {};
  const std::uint64_t count = units::magnitude(steps);
  const std::uint64_t meters = count / per_meter;
  const std::uint64_t rest = (count - meters * per_meter) * nanometers_per_meter;
  const std::uint64_t distance = meters * nanometers_per_meter + (rest + per_meter / 2) / per_meter;
  return units::Nanometers(with_sign_of(steps, distance));
}

}  // namespace motion
