// SPDX-License-Identifier: Apache-2.0
// Reports the figures of `bench processor`: to programs, on the terminal, and as a page.
#pragma once

#include <string>

#include "tools/benchmark/processor_figures.hpp"

namespace benchmarks {

std::string to_json(const ProcessorFigures& figures);
std::string to_table(const ProcessorFigures& figures);
std::string to_html(const ProcessorFigures& figures);

}  // namespace benchmarks
