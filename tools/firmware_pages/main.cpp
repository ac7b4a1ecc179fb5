// SPDX-License-Identifier: Apache-2.0
// firmware_pages: writes a page from a table of the firmware, or checks that it is fresh.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <filesystem>
#include <map>
#include <string>

#include "files/file_text.hpp"
#include "files/write_text.hpp"
#include "firmware_pages/pages.hpp"

int main(int argument_count, char** arguments) {
  const std::map<std::string, std::string (*)()> pages{{"gcodes", firmware_pages::gcodes},
                                                       {"tasks", firmware_pages::tasks}};
  CLI::App app{"Writes a page from a table that the firmware is compiled from."};
  std::string name;
  std::filesystem::path file;
  bool check = false;
  app.add_option("PAGE", name, "Which one")->required()->check(CLI::IsMember(pages));
  app.add_option("FILE", file, "Where it is")->required();
  app.add_flag("--check", check, "Write nothing; fail if the page is stale");
  CLI11_PARSE(app, argument_count, arguments);

  const std::string wanted = pages.at(name)();
  if (files::text_of(file) == wanted) return 0;
  if (check) {
    fmt::print(stderr, "{} is stale: run the target `generate`\n", file.string());
    return 1;
  }
  try {
    files::write_text(file, wanted);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  fmt::print("{}\n", file.string());
  return 0;
}
