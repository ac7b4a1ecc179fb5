// SPDX-License-Identifier: Apache-2.0
// Writing a file as a whole or not at all.
#pragma once

#include <filesystem>
#include <string>

namespace report {

// Writes a new file next to it and renames that, so that a reader, a full disk or a kill never
// meets half a file; makes the folder where it is missing. What is no regular file (/dev/stdout) is
// written directly. Throws std::runtime_error, and what stood there is there still.
void write_file(const std::filesystem::path& file, const std::string& text);

}  // namespace report
