// SPDX-License-Identifier: Apache-2.0
// Files with passwords.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace notify {

// The first lines of a file that other users cannot read (mode 600), none of them empty and each of
// at most 2000 characters. Throws std::runtime_error.
std::vector<std::string> read_secret(const std::filesystem::path& file, std::size_t lines);

}  // namespace notify
