// SPDX-License-Identifier: Apache-2.0
// Impulses of the shapers. ZV and ZVD: Singer and Seering, "Preshaping command inputs to reduce
// system vibration", 1990. EI and two-hump EI with a tolerance of 5 %: Singhose, Seering and
// Singer, "Residual vibration reduction using vector diagrams", 1994. MZV: Klipper.
#include "sim/report/input_shaper.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace report {

namespace {

struct Impulse {
  double weight{};  // not normalized
  double periods{};  // of the damped mode
};

// `decay`: of the mode over a part of its period.
template <class Decay>
std::vector<Impulse> impulses_of(ShaperKind kind, const Decay& decay) {
  constexpr double tolerance = 0.05;
  constexpr double square = tolerance * tolerance;
  const double half = decay(0.5);
  switch (kind) {
    case ShaperKind::zv:
      return {{1, 0}, {half, 0.5}};
    case ShaperKind::zvd:
      return {{1, 0}, {2 * half, 0.5}, {half * half, 1}};
    case ShaperKind::mzv: {
      const double part = decay(0.375);
      const double first = 1 - std::numbers::sqrt2 / 2;
      return {{first, 0}, {(std::numbers::sqrt2 - 1) * part, 0.375}, {first * part * part, 0.75}};
    }
    case ShaperKind::ei:
      return {{(1 + tolerance) / 4, 0},
              {(1 - tolerance) / 2 * half, 0.5},
              {(1 + tolerance) / 4 * half * half, 1}};
    case ShaperKind::two_hump_ei: {
      const double x = std::cbrt(square * (std::sqrt(1 - square) + 1));
      const double first = (3 * x * x + 2 * x + 3 * square) / (16 * x);
      const double second = (0.5 - first) * half;
      return {{first, 0}, {second, 0.5}, {second * half, 1}, {first * half * half * half, 1.5}};
    }
    case ShaperKind::none:
      break;
  }
  return {{1, 0}};
}

}  // namespace

std::optional<ShaperKind> shaper_named(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, ShaperKind>, 7> names{
      {{"none", ShaperKind::none},
       {"zv", ShaperKind::zv},
       {"zvd", ShaperKind::zvd},
       {"mzv", ShaperKind::mzv},
       {"ei", ShaperKind::ei},
       {"2hump_ei", ShaperKind::two_hump_ei},
       {"ei2", ShaperKind::two_hump_ei}}};
  std::string small(name);
  std::ranges::transform(small, small.begin(), [](unsigned char character) {
    return static_cast<char>(std::tolower(character));
  });
  const auto found = std::ranges::find(names, small, &decltype(names)::value_type::first);
  return found == names.end() ? std::nullopt : std::optional(found->second);
}

bool ShapingSetting::any() const {
  return advance_us > 0 || std::ranges::any_of(shapers, [](const ShaperSetting& shaper) {
           return shaper.kind != ShaperKind::none;
         });
}

ShaperTimes times_of(const ShaperSetting& setting) {
  if (setting.kind == ShaperKind::none || setting.millihertz <= 0) return {};
  constexpr double most_damping = 0.99;
  const double damping = std::min(static_cast<double>(setting.damping) * 1e-4, most_damping);
  const double root = std::sqrt(1 - damping * damping);
  const double period = 1000 / (static_cast<double>(setting.millihertz) * root);
  const std::vector<Impulse> impulses = impulses_of(setting.kind, [&](double periods) {
    return std::exp(-2 * std::numbers::pi * damping / root * periods);
  });
  double sum = 0, mean = 0, deviation = 0;
  for (const Impulse& impulse : impulses) {
    sum += impulse.weight;
    mean += impulse.weight * impulse.periods;
  }
  mean /= sum;
  for (const Impulse& impulse : impulses) {
    deviation += impulse.weight / sum * std::abs(impulse.periods - mean);
  }
  return {impulses.size(), impulses.back().periods * period, deviation * period};
}

}  // namespace report
