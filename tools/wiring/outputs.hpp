// SPDX-License-Identifier: Apache-2.0
// The files that are made of the interface board's description.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "tools/wiring/board_wires.hpp"
#include "tools/wiring/description.hpp"

namespace wiring {

// Of designators, kind, value, number of parts: a row for all parts alike.
std::string parts_list(const Description& description);
// As KiCad reads it (version "E" of its format).
std::string netlist(const Description& description);
// Circuits, values with their calculations, facts with their sources.
std::string schematic_page(const Description& description);
// The circuits as a picture (SVG).
std::string schematic_picture(const Description& description);
// Which pin of the board leads to which position of the interface board, or to which signal of a
// printer that has none (SVG).
std::string wiring_picture(const Description& description, const Board& board,
                           const std::vector<Wire>& wires, const PrinterSignals& printer_signals);

// All files by their path in the project.
std::map<std::filesystem::path, std::string> outputs_of(const std::filesystem::path& project,
                                                        const Description& description);

}  // namespace wiring
