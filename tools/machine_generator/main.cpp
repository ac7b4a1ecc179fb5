// SPDX-License-Identifier: Apache-2.0
// machine_generator: writes machine/machine.hpp of a machine description.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>

#include "machine_generator/header.hpp"
#include "machine_generator/reader.hpp"

int main(int argument_count, char** arguments) {
  CLI::App app{"Writes the firmware's constants of a machine description."};
  std::filesystem::path machine;
  std::filesystem::path output;
  app.add_option("machine", machine, "Description, such as firmware/machines/prusa_mendel.toml")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("--output", output, "The header to write")->required();
  bool fast = false;
  app.add_flag("--fast", fast,
               "for firmware that is compiled for speed where the chip's memory suffices");
  CLI11_PARSE(app, argument_count, arguments);

  try {
    const std::string text =
        fast ? machine_generator::header_of(machine) : machine_generator::small_header_of(machine);
    std::filesystem::create_directories(output.parent_path());
    std::ofstream stream(output, std::ios::binary);
    stream << text;
    stream.close();
    if (stream.good()) return 0;
    fmt::print(stderr, "{}: cannot be written\n", output.string());
  } catch (const machine_generator::DescriptionError& error) {
    fmt::print(stderr, "{}\n", error.what());
  }
  return 1;
}
