// SPDX-License-Identifier: Apache-2.0
// Synthesises every board, and reads what came out.
#include "tools/synthesis/all_boards.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tools/files/write_text.hpp"
#include "tools/synthesis/job.hpp"
#include "tools/synthesis/obstacles.hpp"

namespace synthesis {
namespace {

using nlohmann::json;

constexpr std::array boards{"ulx3s", "de2_115", "de2_70", "core"};

int block_kbit(const std::string& family) {
  if (family == "ECP5") return 18;
  if (family == "Cyclone IV E") return 8;
  return 4;  // Cyclone II, iCE40
}

json as_json(const BoardFigures& board) {
  json row = {{"board", board.board},
              {"device", board.device},
              {"logic", {{"used", board.logic}, {"available", board.logic_there}}},
              {"registers", board.registers},
              {"ram_kbit", board.ram_kbit},
              {"multipliers", board.multipliers}};
  if (board.fastest_mhz > 0) row["fastest_mhz"] = board.fastest_mhz;
  return row;
}

}  // namespace

BoardFigures read_board_figures(const std::filesystem::path& synthesis_json) {
  BoardFigures board;
  try {
    std::ifstream stream(synthesis_json);
    const json object = json::parse(stream);
    const char* logic = object.contains("logic_elements") ? "logic_elements" : "logic_cells";
    board.board = object.at("board");
    board.device = object.at("device");
    board.logic = object.at(logic).at("used");
    board.logic_there = object.at(logic).at("available");
    board.registers = object.at("registers").at("used");
    board.ram_kbit =
        object.at("block_rams").at("used").get<int>() * block_kbit(object.at("family"));
    board.multipliers = object.at("multipliers").at("used");
    board.fastest_mhz = object.value("fastest_mhz", 0.0);
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("{}: {}", synthesis_json.string(), error.what()));
  }
  return board;
}

std::string as_table(const std::vector<BoardFigures>& figures) {
  std::string text = fmt::format("{:<10}{:<16}{:>18}{:>11}{:>10}{:>13}{:>8}\n", "board", "device",
                                 "logic", "registers", "RAM kbit", "multipliers", "MHz");
  for (const BoardFigures& board : figures) {
    text += fmt::format("{:<10}{:<16}{:>18}{:>11}{:>10}{:>13}{:>8}\n", board.board, board.device,
                        fmt::format("{} of {}", board.logic, board.logic_there), board.registers,
                        board.ram_kbit, board.multipliers,
                        board.fastest_mhz > 0 ? fmt::format("{:.1f}", board.fastest_mhz) : "");
  }
  return text;
}

bool synthesize_all(const Options& options, const std::filesystem::path& project,
                    const std::filesystem::path& firmware, const std::function<void()>& look) {
  bool good = true;
  std::vector<BoardFigures> figures;
  json rows = json::array();
  std::vector<Options> possible;
  for (const char* board : boards) {
    Options one = options;
    one.all = false;
    one.board = board;
    one.directory = options.directory / board;
    // Without a printer around it.
    if (one.board == "core") {
      one.machine.clear();
      one.debug = false;
    }
    if (const std::string obstacle = obstacle_to(one, project); !obstacle.empty()) {
      fmt::print(stderr, "{} is left out: {}\n", board, obstacle);
      good = false;
      continue;
    }
    possible.push_back(one);
  }
  for (const Options& one : possible) {
    good &= synthesize(one, project, firmware, look);
    figures.push_back(read_board_figures(one.directory / "synthesis.json"));
    rows.push_back(as_json(figures.back()));
    std::fflush(stdout);
  }
  files::write_text(options.directory / "boards.json", rows.dump(2) + "\n");
  fmt::print("{}", as_table(figures));
  return good;
}

}  // namespace synthesis
