// SPDX-License-Identifier: Apache-2.0
// Where the boards have what does not lie at the interface board's header, and which balls their
// devices have: stated here a second time, so that a mistake in the tables is seen.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace synthesis {

// One sentence for each port that lies elsewhere than on the board, and for each signal of the
// board's table on a ball that its device does not have.
std::vector<std::string> misplaced_in(const std::filesystem::path& project,
                                      const std::string& board);

}  // namespace synthesis
