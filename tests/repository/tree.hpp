// SPDX-License-Identifier: Apache-2.0
// The files of the tree, for checks of their text.
#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "directories.hpp"
#include "tools/files/file_text.hpp"

namespace repository {

namespace fs = std::filesystem;

inline const fs::path project = PROJECT_DIRECTORY;

inline bool lies_in_a_hidden_or_build_folder(const fs::path& relative) {
  const std::string first = relative.begin()->string();
  return first == "build" || first == ".git" || first == ".cache" || first == "report";
}

// All files of the tree, but for build products, as paths relative to the project.
inline std::vector<fs::path> files(const std::set<std::string>& extensions,
                                   const fs::path& below = "") {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(project / below)) {
    const fs::path relative = fs::relative(entry.path(), project);
    if (!entry.is_regular_file() || lies_in_a_hidden_or_build_folder(relative)) continue;
    if (extensions.contains(relative.extension().string())) found.push_back(relative);
  }
  std::ranges::sort(found);
  return found;
}

inline const std::set<std::string> source_extensions{".vhd", ".cpp",   ".hpp",  ".c",  ".h",  ".S",
                                                     ".sh",  ".cmake", ".toml", ".ld", ".vlt"};

inline bool is_generated(const fs::path& relative) {
  const std::string folder = relative.parent_path().string();
  return (folder == "rtl/registers" || folder == "firmware/registers") &&
         relative.extension() != ".md";
}

// The lines of a file of the tree.
inline std::vector<std::string> lines_of(const fs::path& relative) {
  std::istringstream text(::files::text_of(project / relative));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

}  // namespace repository
