// SPDX-License-Identifier: Apache-2.0
// Calls the scripts of tools/hardware for a board with a Cyclone, and reports what came out.
#include "tools/synthesis/quartus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "tools/files/write_text.hpp"
#include "tools/process/process.hpp"
#include "tools/synthesis/job.hpp"

namespace synthesis {
namespace {

using nlohmann::json;

// Bits of the block in which Yosys counts the chip's queues.
constexpr int yosys_block_bits = 8192;

int count_of(const json& cells, const char* kind) {
  const auto found = cells.find(kind);
  return found == cells.end() ? 0 : found->get<int>();
}

int blocks_for(int bits, int block_bits) { return (bits + block_bits - 1) / block_bits; }

}  // namespace

bool has_cyclone(const std::filesystem::path& project, const std::string& board) {
  return std::filesystem::exists(project / "boards" / board / "device.csv");
}

std::map<std::string, std::string> board_properties(const std::filesystem::path& board_folder) {
  std::ifstream stream(board_folder / "device.csv");
  std::map<std::string, std::string> properties;
  for (std::string line; std::getline(stream, line);) {
    const std::size_t comma = line.find(',');
    if (comma != std::string::npos) properties[line.substr(0, comma)] = line.substr(comma + 1);
  }
  return properties;
}

CycloneReport read_cyclone_report(const std::filesystem::path& cells,
                                  const std::filesystem::path& board_folder,
                                  std::uint32_t memory_bytes) {
  CycloneReport report;
  report.memory_bytes = memory_bytes;
  report.board = board_folder.filename().string();
  try {
    const auto properties = board_properties(board_folder);
    report.family = properties.at("family");
    report.device = properties.at("device");
    report.quartus = properties.at("quartus");
    report.logic_elements_there = std::stoi(properties.at("logic_elements"));
    report.block_rams_there = std::stoi(properties.at("block_rams"));
    report.multipliers_there = std::stoi(properties.at("multipliers"));
    const int block_bits = std::stoi(properties.at("block_ram_bits"));
    std::ifstream stream(cells);
    const json counts = json::parse(stream).at("design").at("num_cells_by_type");
    // A logic element is a table and a register, which may belong together or not.
    const int tables = counts.at("cycloneive_lcell_comb");
    report.registers = counts.at("dffeas");
    report.logic_elements = std::max(tables, report.registers);
    const int queues = count_of(counts, "cyclone_block_ram");
    // The chip's memory is of blocks that Yosys does not count.
    report.block_rams = blocks_for(static_cast<int>(memory_bytes) * 8, block_bits) +
                        queues * blocks_for(yosys_block_bits, block_bits);
    report.multipliers = count_of(counts, "cyclone_multiplier");
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("{}: {}", cells.string(), error.what()));
  }
  return report;
}

std::string as_json(const CycloneReport& report) {
  const auto usage = [](int used, int available) {
    return json{{"used", used}, {"available", available}};
  };
  const json object = {
      {"board", report.board},
      {"family", report.family},
      {"device", report.device},
      {"has_debug", report.has_debug},
      {"memory_bytes", report.memory_bytes},
      {"logic_elements", usage(report.logic_elements, report.logic_elements_there)},
      {"registers", usage(report.registers, report.logic_elements_there)},
      {"block_rams", usage(report.block_rams, report.block_rams_there)},
      {"multipliers", usage(report.multipliers, report.multipliers_there)}};
  return object.dump(2) + "\n";
}

std::string as_table(const CycloneReport& report) {
  std::string text = fmt::format(
      "{} with a {} {}{}, {} KiB of memory, as Yosys counts the cells of a Cyclone IV E\n",
      report.board, report.family, report.device, report.has_debug ? ", with its debug port" : "",
      report.memory_bytes / 1024);
  const auto row = [&text](const char* name, int used, int there) {
    text += fmt::format("  {:<24}{:>7} of {:>6}{:>5} %\n", name, used, there, 100 * used / there);
  };
  row("logic elements, at least", report.logic_elements, report.logic_elements_there);
  row("registers", report.registers, report.logic_elements_there);
  row("block RAMs", report.block_rams, report.block_rams_there);
  row("multipliers 18 x 18", report.multipliers, report.multipliers_there);
  return text;
}

bool make_quartus_project(const Options& options, const std::filesystem::path& project,
                          const std::filesystem::path& firmware,
                          const std::filesystem::path& directory,
                          const std::function<void()>& look) {
  const std::filesystem::path tools = project / "tools/hardware", folder = directory / "quartus";
  const auto call = [&look](const std::vector<std::string>& words) {
    if (process::run({.arguments = words}, {}, look).exit_status != 0) {
      throw std::runtime_error("the synthesis failed");
    }
  };
  if (options.firmware_only) {
    if (!std::filesystem::exists(folder / "make_project.tcl")) {
      throw std::runtime_error(
          fmt::format("{} has no project: without --firmware-only one is made", folder.string()));
    }
    call({(tools / "write_mif.sh").string(), firmware.string(),
          std::to_string(options.memory_bytes), folder.string()});
    fmt::print("{0} has the firmware: quartus_cdb --update_mif {1} && quartus_asm {1} there\n",
               folder.string(), options.board);
    return true;
  }
  std::filesystem::remove(directory / "synthesis.json");
  std::vector<std::string> words{(tools / "write_quartus_project.sh").string(),
                                 project.string(),
                                 options.board,
                                 firmware.string(),
                                 folder.string(),
                                 fmt::format("-gmemory_size_bytes={}", options.memory_bytes)};
  if (options.debug) words.emplace_back("-ghas_debug=true");
  if (options.zbb) words.emplace_back("-ghas_zbb=true");
  call(words);
  fmt::print("The Quartus project is in {}; Yosys counts its cells\n", folder.string());
  std::fflush(stdout);
  call({(tools / "synthesize_cyclone.sh").string(), project.string(), options.board,
        folder.string()});
  CycloneReport report = read_cyclone_report(
      folder / "cells.json", project / "boards" / options.board, options.memory_bytes);
  report.has_debug = options.debug;
  files::write_text(directory / "synthesis.json", as_json(report));
  fmt::print("{}  bitstream: Quartus {}, quartus_sh -t make_project.tcl in {}\n", as_table(report),
             report.quartus, folder.string());
  return report.fits();
}

}  // namespace synthesis
