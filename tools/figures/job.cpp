// SPDX-License-Identifier: Apache-2.0
// The job and its options.
#include "tools/figures/job.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <stdexcept>

#include "tools/figures/measure.hpp"
#include "tools/figures/project.hpp"
#include "tools/files/write_text.hpp"

namespace figures {

namespace {

void list(const Project& project) {
  for (const auto& [name, group] : project.groups) {
    const auto record = project.store.find(name);
    fmt::print("{:<18}{:<12}{:>4} min  {}\n", name,
               record == project.store.end() ? "never" : record->second.measured, group.minutes,
               group.about);
  }
}

const Group& group_named(const Project& project, const std::string& name) {
  const auto group = project.groups.find(name);
  if (group == project.groups.end()) {
    throw std::runtime_error(fmt::format("there is no group {}", name));
  }
  return group->second;
}

bool report(const std::vector<std::string>& problems) {
  for (const std::string& problem : problems) fmt::print(stderr, "{}\n", problem);
  return problems.empty();
}

}  // namespace

void add_options(CLI::App& job, Options& options) {
  auto* names = job.add_option("names", options.names,
                               "groups to measure; all: every one. Without any: writes the pages "
                               "from the file, and lists the groups")
                    ->type_name("NAME...");
  job.add_flag("--check", options.check, "only compare the pages with tools/figures/figures.json")
      ->excludes(names);
}

bool run(const Options& options, const std::filesystem::path& project_folder,
         const std::filesystem::path& build_folder, const Build& build,
         const std::function<void()>& look) {
  const Project project = read_project(project_folder);
  if (options.check) return report(problems_of(project));
  std::vector<std::string> names = options.names;
  if (names == std::vector<std::string>{"all"}) {
    names.clear();
    for (const auto& [name, group] : project.groups) names.push_back(name);
  }
  for (const std::string& name : names) group_named(project, name);
  for (const std::string& name : names) {
    const Group& group = group_named(project, name);
    fmt::print(stderr, "stepfabric: {}: {}, some {} min\n", name, group.command_text(),
               group.minutes);
    if (!group.build.empty()) build(group.build);
    const Record record = measure(group, {project_folder, build_folder, look});
    // Groups measured so far stay written.
    Store store = read_store(store_file(project_folder));
    store[name] = record;
    files::write_text(store_file(project_folder), to_json(store));
  }
  if (names.empty()) list(project);
  return report(update_pages(read_project(project_folder)));
}

}  // namespace figures
