// SPDX-License-Identifier: Apache-2.0
// What `print` says at its end.
#pragma once

#include "sim/report/results.hpp"
#include "tools/command/print_job.hpp"

namespace command {

void print_summary(const PrintOptions& options, const report::Results& results);

}  // namespace command
