// SPDX-License-Identifier: Apache-2.0
// Writing a file as a whole or not at all.
#pragma once

#include <filesystem>
#include <string>

namespace files {

// Whether it is a symlink of another user, except root, whose target must not be overwritten.
bool is_foreign_link(const std::filesystem::path& file);
// Throws std::runtime_error where it is.
void refuse_foreign_link(const std::filesystem::path& file);

// Writes a new file next to it and renames that, so that a reader, a full disk or a kill never
// meets half a file; makes the folder where it is missing. What is no regular file (/dev/stdout) is
// written directly, and a foreign link is refused. Throws std::runtime_error, and what stood there
// is there still.
void write_file(const std::filesystem::path& file, const std::string& text);

}  // namespace files
