// SPDX-License-Identifier: Apache-2.0
// What the circuit behind each signal of a board needs of its pin, and where a board falls short.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace synthesis {

// One sentence for each shortcoming of the board's generated constraints and tables.
std::vector<std::string> shortcomings_of(const std::filesystem::path& project,
                                         const std::string& board);

}  // namespace synthesis
