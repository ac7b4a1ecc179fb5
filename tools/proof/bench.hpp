// SPDX-License-Identifier: Apache-2.0
// Test benches, which catch the faults that no solver can follow.
#pragma once

#include "tools/proof/task.hpp"

namespace proof {

// Runs the GHDL bench `bench` of the folder testbench on `sources`. `fails` where the bench itself
// finds something; `broken` where it cannot be run; `undecided` where it does not end in time.
Outcome run_bench(const Folders& folders, const std::filesystem::path& sources,
                  const std::string& bench, const std::filesystem::path& folder,
                  std::chrono::seconds limit);

}  // namespace proof
