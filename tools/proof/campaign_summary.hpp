// SPDX-License-Identifier: Apache-2.0
// RESULTS.md: the score of each file, from the lists that --record writes.
#pragma once

#include <filesystem>
#include <string>

namespace proof {

// The text for the lists (*.tsv) in `folder`. Throws std::runtime_error for a fate that
// there is none.
std::string summary_of(const std::filesystem::path& folder);

// Writes it into the folder. Throws std::runtime_error where that fails.
void write_summary(const std::filesystem::path& folder);

}  // namespace proof
