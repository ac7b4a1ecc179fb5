// SPDX-License-Identifier: Apache-2.0
// How long urgent commands wait while lines of a job are queued: temperature queries, then M112.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/machine/description.hpp"
#include "sim/simulation/elf_image.hpp"

namespace benchmarks {

struct UrgentOrder {
  std::vector<std::string> lines;  // of the job, numbered from 0
  std::size_t questions{};  // before M112, each at another moment, with three lines in flight
  std::size_t in_flight = 4;
  bool numbered{};  // M105 and M112, as OctoPrint sends them
  std::uint32_t clock_hz{};
  std::uint32_t baud{};
  std::uint64_t seed = 1;  // of the moments
};

struct UrgentRun {
  // From the end of the question's last bit to the first bit of its answer.
  std::vector<double> answers_us;
  // From the end of the last bit of M112 to the motors being off.
  double stop_us{};
};

// `look` is called many times a second; what it throws ends the run. Throws std::runtime_error
// where the chip does not answer.
UrgentRun run_urgent(const sim::ElfImage& firmware, const machine::Description& description,
                     const UrgentOrder& order, const std::function<void()>& look);

}  // namespace benchmarks
