// SPDX-License-Identifier: Apache-2.0
// Which files a job reads and which it writes: none of them twice.
#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace command {

struct NamedFile {
  std::string name;  // as the user gave it: --edges
  std::filesystem::path path;  // empty where the user gave none
};

// Throws std::runtime_error, with both names, where a file to write is one to read, or another one
// to write, by whatever path, symlink or hard link. What is no regular file (/dev/null) may be
// written twice.
void check_that_files_differ(std::span<const NamedFile> read, std::span<const NamedFile> written);

}  // namespace command
