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

// value / 10^9 for value < 2^63: 10^9 is 2^9 * 1 953 125, and the latter has 21 bits, so that three
// 32-bit divisions of 32, 11 and 11 new bits suffice.
Quotient divide_by_billion(std::uint64_t value) {
  constexpr auto divisor = static_cast<std::uint32_t>(one_step.count());
  static_assert(std::uint64_t{divisor} << 9 == nanometers_per_meter);
  const auto upper = static_cast<std::uint32_t>(value >> 31);
  const auto lower = static_cast<std::uint32_t>(value >> 9) & 0x3F'FFFF;
  const std::uint32_t middle = upper % divisor << 11 | lower >> 11;
  const std::uint32_t last = middle % divisor << 11 | (lower & 0x7FF);
  return {(std::uint64_t{upper / divisor} << 22) + (middle / divisor << 11) + last / divisor,
          last % divisor};
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
  const bool negative = position < units::Position();
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
    parts += static_cast<std::uint32_t>(size.femtometers()) * std::uint64_t{factor} /
             units::Position::femtometers_per_nanometer;
  }
  const Quotient rounded = divide_by_billion(parts);
  const std::int32_t residual = static_cast<std::int32_t>(rounded.rest) - one_step.count() / 2;
  const auto count = static_cast<std::int64_t>(steps + rounded.whole);
  return {.steps = negative ? -count : count,
          .residual = StepParts(negative ? -residual : residual)};
}

units::Nanometers position_of(std::int64_t steps, units::StepsPerMeter steps_per_meter) {
  const auto divisor = static_cast<std::uint32_t>(steps_per_meter.count());
  if (divisor == 0) return {};
  const std::uint64_t count = units::magnitude(steps);
  const std::uint64_t meters = count / divisor;
  const std::uint64_t rest = count % divisor * nanometers_per_meter;
  const std::uint64_t distance = meters * nanometers_per_meter + (rest + divisor / 2) / divisor;
  return units::Nanometers(with_sign_of(steps, distance));
}

}  // namespace motion
