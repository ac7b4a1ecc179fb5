// SPDX-License-Identifier: Apache-2.0
// What is wrong with the interface board: circuits, calculations, agreement with the project.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tools/wiring/description.hpp"

namespace wiring {

// One sentence for each.
std::vector<std::string> problems_of(const std::filesystem::path& project,
                                     const Description& description);

}  // namespace wiring
