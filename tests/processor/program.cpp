// SPDX-License-Identifier: Apache-2.0
// Reads a program as objcopy and nm leave it.
#include "tests/processor/program.hpp"

#include <filesystem>
#include <fstream>
#include <ios>
#include <stdexcept>

#include "tests/processor/chip.hpp"

namespace processor {

Program read_program(const std::string& name) {
  const std::filesystem::path folder = PROGRAMS_DIRECTORY;
  Program program{.image = read_image(folder / (name + ".bin")), .symbols = {}};
  std::ifstream file(folder / (name + ".symbols"));
  if (!file) throw std::runtime_error("no symbols of " + name);
  std::uint32_t address = 0;
  std::string kind, symbol;
  while (file >> std::hex >> address >> kind >> symbol) program.symbols[symbol] = address;
  return program;
}

}  // namespace processor
