// SPDX-License-Identifier: Apache-2.0
// Usage: synthesize_board BOARD DIRECTORY. Fails where the chip does not fit.
#include <fmt/format.h>

#include <exception>
#include <stdexcept>

#include "directories.hpp"
#include "tools/synthesis/job.hpp"

int main(int argc, char** argv) try {
  if (argc != 3) throw std::invalid_argument("usage: synthesize_board BOARD DIRECTORY");
  synthesis::Options options;
  options.board = argv[1];
  options.directory = argv[2];
  options.zbb = false;
  return synthesis::synthesize(options, PROJECT_DIRECTORY, BUILD_DIRECTORY "/firmware/firmware.elf")
             ? 0
             : 1;
} catch (const std::exception& error) {
  fmt::print(stderr, "synthesize_board: {}\n", error.what());
  return 1;
}
