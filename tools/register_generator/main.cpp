// SPDX-License-Identifier: Apache-2.0
// register_generator: from register descriptions to VHDL, C++ and Markdown, or a check that those
// are fresh.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>

#include "files/file_text.hpp"
#include "register_generator/description.hpp"

namespace {

namespace fs = std::filesystem;

// Writes the file, or with `check` only compares. Returns false if it is stale (or could not
// be written).
bool settle(const fs::path& file, const std::string& text, bool check) {
  if (fs::exists(file) && files::text_of(file) == text) return true;
  if (check) {
    fmt::print(stderr, "{} is stale: run the target `generate`\n", file.string());
    return false;
  }
  fs::create_directories(file.parent_path());
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  fmt::print("{}\n", file.string());
  return stream.good();
}

}  // namespace

int main(int argument_count, char** arguments) {
  CLI::App app{"Writes VHDL, C++ and Markdown from register descriptions."};
  fs::path project;
  bool check = false;
  app.add_option("--project", project, "The project's folder")
      ->required()
      ->check(CLI::ExistingDirectory);
  app.add_flag("--check", check, "Write nothing; fail if a generated file is stale");
  CLI11_PARSE(app, argument_count, arguments);

  using namespace register_generator;
  const fs::path rtl = project / "rtl/registers", firmware = project / "firmware/registers";
  bool good = true;
  try {
    std::vector<Peripheral> peripherals;
    for (const fs::path& file : description_files(project / "rtl")) {
      const Peripheral peripheral = load(file);
      const std::string source = fs::relative(file, project).generic_string();
      const std::string stem = peripheral.name + "_registers";
      good &= settle(rtl / (stem + "_pkg.vhd"), vhdl_package(peripheral, source), check);
      good &= settle(rtl / (stem + ".vhd"), vhdl_registers(peripheral, source), check);
      good &= settle(firmware / (stem + ".hpp"), cpp_file(peripheral, source), check);
      good &= settle(rtl / (peripheral.name + ".md"), markdown_file(peripheral, source), check);
      peripherals.push_back(peripheral);
    }
    const std::vector<Interrupt> interrupts = interrupts_of(peripherals);
    good &= settle(rtl / "interrupts_pkg.vhd", vhdl_interrupts(interrupts), check);
    good &= settle(firmware / "interrupts.hpp", cpp_interrupts(interrupts), check);
    good &= settle(rtl / "interrupts.md", markdown_interrupts(interrupts), check);
  } catch (const DescriptionError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
  return good ? 0 : 1;
}
