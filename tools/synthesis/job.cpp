// SPDX-License-Identifier: Apache-2.0
// Calls tools/hardware/synthesize_board.sh and tells what came out.
#include "tools/synthesis/job.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "tools/synthesis/report.hpp"

namespace synthesis {
namespace {

std::string quoted(const std::filesystem::path& path) {
  std::string text = "'";
  for (const char character : path.string()) {
    if (character == '\'') {
      text += "'\\''";
    } else {
      text += character;
    }
  }
  return text + "'";
}

}  // namespace

void add_options(CLI::App& job, Options& options) {
  job.add_option("board", options.board,
                 "a board with an ECP5: ulx3s; or core: the processor with its memory alone")
      ->required()
      ->check(CLI::IsMember({"ulx3s", "core"}))
      ->type_name("BOARD");
  job.add_option("--device", options.device, "which ECP5 it bears")
      ->check(CLI::IsMember({"25k", "45k", "85k"}))
      ->capture_default_str();
  job.add_option("--seed", options.seed,
                 "where the placement starts from; the clock varies with it")
      ->capture_default_str();
  job.add_option("--directory", options.directory,
                 "folder for the bitstream, synthesis.json and the tools' logs")
      ->type_name("DIR")
      ->capture_default_str();
  job.footer(
      "Exit status: 0 the bitstream is there and fast enough, 1 it is too slow, 2 a tool failed.");
}

bool synthesize(const Options& options, const std::filesystem::path& project,
                const std::filesystem::path& firmware) {
  std::filesystem::create_directories(options.directory);
  const std::filesystem::path directory = std::filesystem::absolute(options.directory);
  const std::string command =
      fmt::format("{} {} {} {} {} {} {}", quoted(project / "tools/hardware/synthesize_board.sh"),
                  quoted(project), options.board, quoted(firmware), options.device, options.seed,
                  quoted(directory));
  if (std::system(command.c_str()) != 0) {
    throw std::runtime_error("the synthesis failed");
  }
  Report report = read_report(directory);
  report.board = options.board;
  report.device = options.device;
  std::ofstream(directory / "synthesis.json") << as_json(report);
  fmt::print("{}", as_table(report));
  fmt::print("  report, logs and, for a board, the bitstream in {}\n", directory.string());
  return report.fast_enough();
}

}  // namespace synthesis
