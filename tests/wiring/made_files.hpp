// SPDX-License-Identifier: Apache-2.0
// Reads the interface board's netlist and the wiring pictures, by other code than made them.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace wiring_files {

struct Component {
  std::string value;
  std::string footprint;
};

struct Netlist {
  std::string version;
  std::map<std::string, Component> components;  // by designator
  std::map<std::string, std::set<std::string>> pins;  // "R101.1" by net

  // The net of a pin, empty where it has none.
  std::string net_of(const std::string& pin) const;
  // Designators of parts of this letter with a pin on both nets.
  std::vector<std::string> between(char letter, const std::string& one,
                                   const std::string& other) const;
};

// Throws std::runtime_error where it is no S-expression, a pin is on two nets, or a node names a
// component that is not there.
Netlist read_netlist(const std::filesystem::path& file);

// What a wiring picture says of a position, or of a port elsewhere (position 0).
struct DrawnWire {
  int position = 0;
  std::string net;
  std::string signal;
  std::string pin;
  std::string words;  // that are drawn there
};
std::vector<DrawnWire> read_picture(const std::filesystem::path& file);

}  // namespace wiring_files
