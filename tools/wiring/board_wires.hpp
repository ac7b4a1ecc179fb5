// SPDX-License-Identifier: Apache-2.0
// Which pin of a board's FPGA each port of its top entity uses, and where that is on a header.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tools/wiring/description.hpp"

namespace wiring {

struct Wire {
  std::string port;  // of the top entity, with its index
  std::string signal;  // as the board's maker calls it
  std::string fpga_pin;
  int position = 0;  // on the header of 40 pins; 0 where it is not there
  // A single wire of a cable leads from it to the interface board.
  bool is_on_cable = false;
};

// Of the tables in boards. Throws std::runtime_error where one is missing or a signal has no pin.
std::vector<Wire> wires_of(const std::filesystem::path& project, const Board& board);

// What the board's printer calls each pin of the FPGA; empty where it has none.
using PrinterSignals = std::map<std::string, std::string>;
PrinterSignals printer_signals_of(const std::filesystem::path& project, const Board& board);

// "GP3" of "gp[3]": what stands on the board.
std::string printed_name(const std::string& signal);

}  // namespace wiring
