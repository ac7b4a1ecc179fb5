// SPDX-License-Identifier: Apache-2.0
// The highest step rates at which the whole firmware prints cleanly.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tools/benchmark/printing_run.hpp"
#include "tools/benchmark/stepping_figures.hpp"

namespace benchmarks {

// The shortest interval between ticks at which a print is clean, and what happens at a shorter one.
struct PrintingLimit {
  std::uint32_t interval_clocks{};
  std::string limited_by;  // empty at the shortest interval that there is
};

struct PrintingRates {
  std::size_t axes{};
  PrintingLimit lines;  // of 500 ticks one after the other
  PrintingLimit one_line;
};

struct PrintingFirmware {
  sim::ElfImage image;
  machine::Description description;  // of the machine that it is built for
};

// For the same axes as `bare`, which has been measured with the same way to make steps.
std::vector<PrintingRates> measure_printing(const Figures& bare, const PrintingFirmware& firmware,
                                            const Scope& scope,
                                            const std::function<void(const std::string&)>& say);

}  // namespace benchmarks
