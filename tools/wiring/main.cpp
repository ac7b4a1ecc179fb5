// SPDX-License-Identifier: Apache-2.0
// wiring: from the interface board's description to its files, or a check that those are fresh.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "tools/files/file_text.hpp"
#include "tools/files/write_text.hpp"
#include "tools/wiring/outputs.hpp"
#include "tools/wiring/problems.hpp"

namespace {

namespace fs = std::filesystem;

// Writes the file, or with `check` only compares. Returns false if it is stale.
bool settle(const fs::path& file, const std::string& text, bool check) {
  if (fs::exists(file) && files::text_of(file) == text) return true;
  if (check) {
    fmt::print(stderr, "{} is stale: run the target `generate`\n", file.string());
    return false;
  }
  files::write_text(file, text);
  fmt::print("{}\n", file.string());
  return true;
}

bool run(const fs::path& project, bool check) {
  const wiring::Description description = wiring::read_description(project);
  const std::vector<std::string> problems = wiring::problems_of(project, description);
  for (const std::string& problem : problems) fmt::print(stderr, "{}\n", problem);
  if (!problems.empty()) return false;
  bool good = true;
  for (const auto& [file, text] : wiring::outputs_of(project, description)) {
    good &= settle(project / file, text, check);
  }
  return good;
}

}  // namespace

int main(int argument_count, char** arguments) {
  CLI::App app{"Writes schematic, parts list, netlist and pictures of the interface board."};
  fs::path project;
  bool check = false;
  app.add_option("--project", project, "The project's folder")
      ->required()
      ->check(CLI::ExistingDirectory);
  app.add_flag("--check", check, "Write nothing; fail if a generated file is stale");
  CLI11_PARSE(app, argument_count, arguments);
  try {
    return run(project, check) ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
