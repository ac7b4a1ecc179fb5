// SPDX-License-Identifier: Apache-2.0
// The highest step rates at which the whole firmware prints cleanly, and punctually.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tools/benchmark/printing_run.hpp"
#include "tools/benchmark/rate_search.hpp"
#include "tools/benchmark/stepping_figures.hpp"

namespace benchmarks {

struct PrintingRates {
  std::size_t axes{};
  Limits lines;  // of 500 ticks one after the other
  Limits one_line;
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
