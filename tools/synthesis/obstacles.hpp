// SPDX-License-Identifier: Apache-2.0
// What makes a synthesis impossible, as far as that is known before a tool runs for minutes.
#pragma once

#include <filesystem>
#include <string>

namespace synthesis {

struct Options;

// For one board, whose memory is too large for its device or cannot be built there; with a remedy.
// Empty where nothing is known.
std::string obstacle_to(const Options& options, const std::filesystem::path& project);

}  // namespace synthesis
