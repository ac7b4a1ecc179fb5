// SPDX-License-Identifier: Apache-2.0
// Proofs about thermistor tables, by the compiler: this file makes no code.
#include "thermal/thermistor_table.hpp"

namespace thermal {
namespace {

// Largest difference between the table and the beta formula, in millidegrees, at points that lie
// between those of the table.
consteval std::int32_t largest_error(const NtcProperties& ntc) {
  const ThermistorTable table(ntc);
  std::int32_t largest = 0;
  for (std::int32_t t = ThermistorTable::lowest.count(); t <= ThermistorTable::highest.count();
       t += 250) {
    const units::Milliohms exact(
        static_cast<std::int64_t>(ntc_ohms(ntc, t / 1000.0) * 1000.0 + 0.5));
    const auto found = table.temperature(exact);
    if (!found) return 1'000'000;
    const std::int32_t error = found->count() - t;
    largest = std::max(largest, error < 0 ? -error : error);
  }
  return largest;
}

constexpr NtcProperties semitec_104gt{units::Milliohms(100'000'000), 4267};
constexpr NtcProperties epcos_100k{units::Milliohms(100'000'000), 4066};
constexpr NtcProperties generic_10k{units::Milliohms(10'000'000), 3435};

static_assert(largest_error(epcos_100k) <= 60);
static_assert(largest_error(semitec_104gt) <= 60);
static_assert(largest_error(generic_10k) <= 60);

// Table and inverse agree to the rounding of a millidegree and a milliohm.
consteval bool is_the_inverse(const NtcProperties& ntc) {
  const ThermistorTable table(ntc);
  for (std::int32_t t = 0; t <= 299'000; t += 777) {
    const auto there_and_back = table.temperature(table.resistance(units::Millicelsius(t)));
    if (!there_and_back) return false;
    const std::int32_t error = there_and_back->count() - t;
    if (error > 2 || error < -2) return false;
  }
  return true;
}
static_assert(is_the_inverse(epcos_100k));

}  // namespace
}  // namespace thermal
