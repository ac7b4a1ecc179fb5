// SPDX-License-Identifier: Apache-2.0
// task_page: writes the page of tasks, or checks that it is fresh.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "task_page/page.hpp"

int main(int argument_count, char** arguments) {
  CLI::App app{"Writes the page of tasks from the firmware's table of tasks."};
  std::filesystem::path file;
  bool check = false;
  app.add_option("FILE", file, "The page")->required();
  app.add_flag("--check", check, "Write nothing; fail if the page is stale");
  CLI11_PARSE(app, argument_count, arguments);

  std::ostringstream present;
  present << std::ifstream(file, std::ios::binary).rdbuf();
  const std::string wanted = task_page::page();
  if (present.str() == wanted) return 0;
  if (check) {
    fmt::print(stderr, "{} is stale: run the target `generate`\n", file.string());
    return 1;
  }
  std::ofstream stream(file, std::ios::binary);
  stream << wanted;
  stream.close();
  if (!stream.good()) {
    fmt::print(stderr, "{} cannot be written\n", file.string());
    return 1;
  }
  fmt::print("{}\n", file.string());
  return 0;
}
