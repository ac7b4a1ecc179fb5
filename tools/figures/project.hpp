// SPDX-License-Identifier: Apache-2.0
// All figures of the project and all its pages.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tools/figures/group.hpp"
#include "tools/figures/page.hpp"
#include "tools/figures/store.hpp"

namespace figures {

struct Project {
  std::filesystem::path folder;
  std::map<std::string, Group> groups;
  Tables tables;
  Store store;
};

// Throws std::runtime_error, with the file, where one cannot be read.
Project read_project(const std::filesystem::path& folder);
std::filesystem::path store_file(const std::filesystem::path& project_folder);

// What is not as it must be: a figure in a page that differs from the file, a figure or table that
// no page shows, a file that was not made by the groups as they are.
std::vector<std::string> problems_of(const Project& project);

// Makes the figures in all pages those of the file; what cannot be made is returned.
std::vector<std::string> update_pages(const Project& project);

}  // namespace figures
