// SPDX-License-Identifier: Apache-2.0
// Netlist, parts list, schematic and wiring pictures of the interface board agree with each other
// and with the boards' tables.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "directories.hpp"
#include "tests/wiring/made_files.hpp"
#include "tools/files/file_text.hpp"
#include "tools/files/table.hpp"

namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using wiring_files::DrawnWire;
using wiring_files::Netlist;

const fs::path boards = fs::path(PROJECT_DIRECTORY) / "boards";
const fs::path folder = boards / "interface";

const Netlist& netlist() {
  static const Netlist list = wiring_files::read_netlist(folder / "interface.net");
  return list;
}

// A port's net in the netlist.
std::string net_of(std::string port) {
  std::erase(port, ']');
  std::ranges::replace(port, '[', '_');
  return port;
}

std::string without_index(const std::string& port) { return port.substr(0, port.find('[')); }

TEST(InterfaceBoard, has_a_netlist_that_kicad_reads) {
  EXPECT_EQ(netlist().version, "E");
  EXPECT_GT(netlist().components.size(), 100u);
  for (const auto& [net, pins] : netlist().pins) EXPECT_GE(pins.size(), 2u) << net;
  for (const auto& [designator, component] : netlist().components) {
    EXPECT_FALSE(component.value.empty()) << designator;
    // The relay stands next to the board.
    EXPECT_EQ(component.footprint.empty(), designator == "K301") << designator;
  }
}

TEST(InterfaceBoard, has_each_part_once_in_its_parts_list) {
  std::map<std::string, int> seen;
  for (const files::Row& row : files::read_table(folder / "parts.csv")) {
    std::istringstream words(row.at("designators"));
    int count = 0;
    for (std::string designator; words >> designator; ++count) {
      ++seen[designator];
      ASSERT_TRUE(netlist().components.contains(designator)) << designator;
      std::string value = netlist().components.at(designator).value;
      std::ranges::replace(value, ',', ';');
      EXPECT_EQ(row.at("value"), value) << designator;
      EXPECT_EQ(row.at("footprint"), netlist().components.at(designator).footprint) << designator;
    }
    EXPECT_EQ(row.at("count"), fmt::format("{}", count));
  }
  EXPECT_EQ(seen.size(), netlist().components.size());
  for (const auto& [designator, times] : seen) EXPECT_EQ(times, 1) << designator;
}

// The picture shows the first of each circuit: designators that end with 0 and a digit.
TEST(InterfaceBoard, has_each_part_in_its_schematic) {
  const std::string page = files::text_of(folder / "schematic.md"),
                    picture = files::text_of(folder / "schematic.svg");
  for (const auto& [designator, component] : netlist().components) {
    EXPECT_TRUE(std::regex_search(page, std::regex("[| ]" + designator + "[ \n]"))) << designator;
    const bool is_of_first = designator.size() == 4 && designator[2] == '0';
    const bool is_drawn = picture.find(">" + designator + "</text>") != std::string::npos;
    EXPECT_EQ(is_drawn, is_of_first) << designator;
  }
}

// Its wires' words name what its data say, and both are as the tables have it. Positions lead to
// the interface board, or to a printer of its own.
enum class Leads { to_the_interface_board, to_a_printer };
void expect_as_tables(const std::string& board, const std::string& column,
                      Leads leads = Leads::to_the_interface_board) {
  SCOPED_TRACE(board);
  std::map<std::string, std::string> pins, positions;
  for (const files::Row& row : files::read_table(boards / board / "pins.csv")) {
    pins[row.at("signal")] = row.at("pin");
  }
  if (!column.empty()) {
    for (const files::Row& row : files::read_table(boards / "header40.csv")) {
      positions[row.at(column)] = row.at("header_pin");
    }
  }
  std::map<std::string, DrawnWire> drawn;
  for (const DrawnWire& wire : wiring_files::read_picture(boards / board / "wiring.svg")) {
    if (wire.position != 0) {
      const std::string pin = fmt::format("J1.{}", wire.position);
      if (leads == Leads::to_the_interface_board) {
        EXPECT_EQ(netlist().net_of(pin), net_of(wire.net)) << pin;
      }
      EXPECT_THAT(wire.words, HasSubstr(fmt::format("{}\n", wire.position)));
    }
    EXPECT_THAT(wire.words, HasSubstr(wire.net));
    if (!wire.pin.empty()) {
      EXPECT_TRUE(drawn.emplace(wire.net, wire).second) << wire.net << " is drawn twice";
      EXPECT_THAT(wire.words, HasSubstr(wire.pin + ")"));
    }
  }
  std::size_t ports = 0;
  for (const files::Row& row : files::read_table(boards / board / "connections.csv")) {
    const std::string& port = row.at("port");
    ASSERT_TRUE(drawn.contains(port)) << port;
    const DrawnWire& wire = drawn.at(port);
    EXPECT_EQ(wire.signal, row.at("signal"));
    EXPECT_EQ(wire.pin, pins.at(row.at("signal")));
    if (positions.contains(wire.pin)) {
      EXPECT_EQ(fmt::format("{}", wire.position), positions.at(wire.pin)) << port;
    }
    ++ports;
  }
  EXPECT_EQ(drawn.size(), ports);
}

TEST(WiringPicture, of_each_board_is_as_its_tables) {
  expect_as_tables("de2_115", "de2_115_JP5_GPIO");
  expect_as_tables("de2_70", "de2_70_J4_pin");
  expect_as_tables("de2_70_reprap_2012", "de2_70_J4_pin", Leads::to_a_printer);
  expect_as_tables("ulx3s", "");
}

TEST(WiringPicture, names_each_signal_of_the_printer_of_2012) {
  std::map<int, std::string> words;
  for (const DrawnWire& wire :
       wiring_files::read_picture(boards / "de2_70_reprap_2012/wiring.svg")) {
    words[wire.position] += wire.words;
  }
  int signals = 0;
  for (const files::Row& row : files::read_table(boards / "de2_70/reprap_2012_pins.csv")) {
    if (row.at("header_pin").empty()) continue;
    EXPECT_THAT(words[std::stoi(row.at("header_pin"))], HasSubstr(row.at("signal")));
    ++signals;
  }
  EXPECT_EQ(signals, 22);
  for (const int supply : {12, 30}) EXPECT_THAT(words[supply], HasSubstr("ground"));
  EXPECT_THAT(words[11], HasSubstr("5 V"));
}

// From the header's pin, or behind its series resistor, to ground or 3.3 V.
std::vector<std::string> holding(const std::string& net, const std::string& rail) {
  std::vector<std::string> found = netlist().between('R', net, rail);
  for (const auto& [other, pins] : netlist().pins) {
    if (other == "GND" || other.starts_with('+') || other == net) continue;
    if (netlist().between('R', net, other).empty()) continue;
    std::ranges::copy(netlist().between('R', other, rail), std::back_inserter(found));
  }
  return found;
}

// What keeps the printer safe while the FPGA is not configured.
TEST(InterfaceBoard, holds_each_signal_as_the_constraints_want_it) {
  int held = 0;
  for (const files::Row& row :
       files::read_table(fs::path(PROJECT_DIRECTORY) / "constraints/signals.csv")) {
    if (row.at("outside").empty()) continue;
    const std::string rail = row.at("outside") == "up" ? "+3V3" : "GND";
    for (const files::Row& port : files::read_table(boards / "de2_115/connections.csv")) {
      if (without_index(port.at("port")) != row.at("port")) continue;
      const auto resistors = holding(net_of(port.at("port")), rail);
      ASSERT_THAT(resistors, SizeIs(1)) << port.at("port");
      const std::string kiloohms =
          fmt::format("{:g} kΩ", std::stod(row.at("outside_ohms")) / 1'000);
      EXPECT_EQ(netlist().components.at(resistors.front()).value, kiloohms) << port.at("port");
      ++held;
    }
  }
  EXPECT_EQ(held, 5 + 2 + 1 + 1 + 1);
}

TEST(InterfaceBoard, has_no_pull_on_a_sensor) {
  for (const auto& [net, pins] : netlist().pins) {
    if (!net.starts_with("sensor_")) continue;
    EXPECT_THAT(netlist().between('R', net, "+3V3"), ElementsAre()) << net;
    EXPECT_THAT(netlist().between('R', net, "GND"), ElementsAre()) << net;
  }
}

// What stands next to the board is reached through terminals: each of its nets has one.
std::vector<std::string> without_terminal(const Netlist& list) {
  std::vector<std::string> found;
  for (const auto& [net, pins] : list.pins) {
    bool leaves = false, has_terminal = false;
    for (const std::string& pin : pins) {
      const auto& component = list.components.at(pin.substr(0, pin.find('.')));
      leaves |= component.footprint.empty();
      has_terminal |= component.footprint.starts_with("TerminalBlock");
    }
    if (leaves && !has_terminal) found.push_back(net);
  }
  return found;
}

TEST(InterfaceBoard, has_a_terminal_for_each_wire_to_a_part_next_to_it) {
  EXPECT_THAT(without_terminal(netlist()), ElementsAre());
}

TEST(InterfaceBoard, without_a_terminal_of_the_relay_is_found) {
  Netlist list = netlist();
  for (auto& [net, pins] : list.pins) {
    std::erase_if(pins, [](const std::string& pin) { return pin.starts_with("J30"); });
  }
  EXPECT_THAT(without_terminal(list), ElementsAre("+HEAT", "relay_coil"));
}

// Both heaters hang on the relay's contact alone, and their MOSFETs alone on their other end.
TEST(InterfaceBoard, leads_the_heaters_current_through_the_relay) {
  EXPECT_THAT(netlist().pins.at("+HEAT"), ElementsAre("F201.1", "F211.1", "J302.2", "K301.87"));
  for (const std::string copy : {"0", "1"}) {
    const std::string low = "heater_" + copy + "_low", q = "Q2" + copy;
    EXPECT_THAT(netlist().pins.at(low), ElementsAre("J2" + copy + "1.2", q + "1.2", q + "2.2"));
  }
}

}  // namespace
