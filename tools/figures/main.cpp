// SPDX-License-Identifier: Apache-2.0
// `figures --check` and `figures` without a name as a program of its own, which needs no model of
// the chip.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "tools/figures/project.hpp"

int main(int count, char** arguments) {
  CLI::App app("Compares the figures in all pages with figures.json.", "check_figures");
  std::filesystem::path project = ".";
  bool write = false;
  app.add_option("project", project, "folder of the project");
  app.add_flag("--write", write, "write the pages first");
  CLI11_PARSE(app, count, arguments);
  try {
    const figures::Project all = figures::read_project(project);
    const auto problems = write ? figures::update_pages(all) : figures::problems_of(all);
    for (const std::string& problem : problems) std::puts(problem.c_str());
    return problems.empty() ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "check_figures: %s\n", error.what());
    return 2;
  }
}
