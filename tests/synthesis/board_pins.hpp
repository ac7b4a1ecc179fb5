// SPDX-License-Identifier: Apache-2.0
// A board's tables, its top entity's ports, and the pin constraints that are generated of them.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tools/files/table.hpp"

namespace synthesis {

using files::read_table;
using files::Row;
using files::row_with;

// One pin of the generated constraints.
struct ConstrainedPin {
  std::string site;
  // For nextpnr IO_TYPE, PULLMODE, DRIVE, SLEWRATE; for Quartus the names of its assignments.
  std::map<std::string, std::string> attributes;
};

struct Constraints {
  // By port with index.
  std::map<std::string, ConstrainedPin> pins;
  // What the script said where it failed, or which line is not understood.
  std::string refusal;
};

// Calls tools/hardware/write_constraints.sh of that project.
Constraints generate_constraints(const std::filesystem::path& project, const std::string& board);

// Each port of a top entity with its index, and `in` or `out`.
std::map<std::string, std::string> ports_of(const std::filesystem::path& entity);

// A port's name without its index.
std::string signal_of(const std::string& port);

}  // namespace synthesis
