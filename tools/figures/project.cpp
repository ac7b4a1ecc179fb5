// SPDX-License-Identifier: Apache-2.0
// Reads or rewrites all pages.
#include "tools/figures/project.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "tools/files/file_text.hpp"
#include "tools/files/write_text.hpp"

namespace figures {

namespace fs = std::filesystem;

namespace {

// Folders of the project's root that hold build products.
bool is_made(const fs::path& relative) {
  const std::string first = relative.begin()->string();
  return first.starts_with('.') || first == "build" || first == "report" || first == "synthesis";
}

std::vector<fs::path> pages_of(const fs::path& project) {
  std::vector<fs::path> pages;
  for (auto entry = fs::recursive_directory_iterator(project);
       entry != fs::recursive_directory_iterator(); ++entry) {
    const fs::path relative = fs::relative(entry->path(), project);
    if (is_made(relative) || relative == "tools/figures/tables") {
      entry.disable_recursion_pending();
    } else if (relative.extension() == ".md") {
      pages.push_back(relative);
    }
  }
  std::ranges::sort(pages);
  return pages;
}

struct Findings {
  std::vector<std::string> problems;
  std::set<std::string> used;
};

template <class Do>
Findings each_page(const Project& project, Do with_page) {
  Findings findings;
  for (const fs::path& file : pages_of(project.folder)) {
    const std::string before = files::text_of(project.folder / file);
    const Page page = with_figures(before, project.store, project.tables, findings.used);
    for (const std::string& problem : page.problems) {
      findings.problems.push_back(fmt::format("{}:{}", file.string(), problem));
    }
    with_page(file, before, page);
  }
  return findings;
}

void compare_with_groups(const Project& project, std::vector<std::string>& problems) {
  for (const auto& [name, group] : project.groups) {
    const auto found = project.store.find(name);
    const auto measure = [&](const char* why) {
      problems.push_back(fmt::format("{} {}: ./stepfabric figures {}", name, why, name));
    };
    if (found == project.store.end()) {
      measure("has not been measured");
      continue;
    }
    const auto& values = found->second.values;
    const bool same_values = values.size() == group.paths.size() + group.matches.size() &&
                             std::ranges::all_of(values, [&](const auto& entry) {
                               return group.has_value(entry.first);
                             });
    if (found->second.command != group.command_text() || !same_values) {
      measure("was measured with another command or other values");
    }
  }
  for (const auto& [name, record] : project.store) {
    if (!project.groups.contains(name)) {
      problems.push_back(fmt::format("figures.json: there is no group {}", name));
    }
  }
}

}  // namespace

fs::path store_file(const fs::path& project_folder) {
  return project_folder / "tools" / "figures" / "figures.json";
}

Project read_project(const fs::path& folder) {
  const fs::path home = folder / "tools" / "figures";
  Project project{.folder = folder,
                  .groups = read_groups(home / "groups"),
                  .tables = {},
                  .store = read_store(store_file(folder))};
  for (const auto& entry : fs::directory_iterator(home / "tables")) {
    if (entry.path().extension() != ".md") continue;
    project.tables[entry.path().stem().string()] = files::text_of(entry.path());
  }
  return project;
}

std::vector<std::string> problems_of(const Project& project) {
  auto [problems, used] = each_page(project, [](const auto&, const auto&, const auto&) {});
  compare_with_groups(project, problems);
  for (const auto& [name, record] : project.store) {
    for (const auto& [value, number] : record.values) {
      if (!used.contains(name + "." + value)) {
        problems.push_back(fmt::format("{}.{}: no page shows it", name, value));
      }
    }
  }
  for (const auto& [name, text] : project.tables) {
    if (!used.contains(name)) problems.push_back(fmt::format("table {}: no page shows it", name));
  }
  return problems;
}

std::vector<std::string> update_pages(const Project& project) {
  each_page(project, [&](const fs::path& file, const std::string& before, const Page& page) {
    if (page.text != before) files::write_text(project.folder / file, page.text);
  });
  // Figures that were written are right; what still differs cannot be generated.
  return problems_of(project);
}

}  // namespace figures
