// SPDX-License-Identifier: Apache-2.0
// Reads a board's tables.
#include "tools/wiring/board_wires.hpp"

#include <fmt/format.h>

#include <cctype>
#include <regex>
#include <stdexcept>

#include "tools/files/table.hpp"

namespace wiring {

std::vector<Wire> wires_of(const std::filesystem::path& project, const Board& board) {
  const std::filesystem::path boards = project / "boards", folder = boards / board.name;
  const auto pins = files::read_table(folder / "pins.csv");
  const auto positions = files::read_table(boards / "header40.csv");
  const std::regex pattern(board.pattern + R"(\[\d+\])");
  std::vector<Wire> wires;
  for (const files::Row& row : files::read_table(folder / "connections.csv")) {
    const std::string& signal = row.at("signal");
    const files::Row* pin = files::row_with(pins, "signal", signal);
    if (pin == nullptr) throw std::runtime_error(fmt::format("{}: no pin {}", board.name, signal));
    Wire wire{.port = row.at("port"), .signal = signal, .fpga_pin = pin->at("pin")};
    if (board.pattern.empty()) {
      const files::Row* place = files::row_with(positions, board.column, wire.fpga_pin);
      if (place != nullptr) wire.position = std::stoi(place->at("header_pin"));
    } else {
      wire.is_on_cable = std::regex_match(signal, pattern);
    }
    wires.push_back(wire);
  }
  return wires;
}

PrinterSignals printer_signals_of(const std::filesystem::path& project, const Board& board) {
  PrinterSignals signals;
  if (board.printer.empty()) return signals;
  for (const files::Row& row : files::read_table(project / "boards" / board.printer)) {
    signals[row.at("pin")] = row.at("signal");
  }
  return signals;
}

std::string printed_name(const std::string& signal) {
  std::string name;
  for (const char c : signal) {
    if (c != '[' && c != ']') {
      name += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    }
  }
  return name;
}

}  // namespace wiring
