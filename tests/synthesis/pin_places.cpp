// SPDX-License-Identifier: Apache-2.0
// Compares a board's tables with what is soldered on the board, as public projects for it have it.
#include "tests/synthesis/pin_places.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <regex>
#include <set>
#include <string_view>

#include "tests/synthesis/board_pins.hpp"

namespace synthesis {
namespace {

using Balls = std::map<std::string, std::string>;

// Adds PORT[0] to PORT[n].
void add(Balls& balls, const std::string& port, const std::vector<std::string>& of_indices) {
  for (std::size_t i = 0; i < of_indices.size(); ++i) {
    balls[fmt::format("{}[{}]", port, i)] = of_indices[i];
  }
}

Balls on_the_de2_115() {
  Balls balls{{"clock_50mhz", "Y2"}, {"clock_25mhz", "A14"}, {"uart_rxd", "G12"},
              {"uart_txd", "G9"},    {"tck", "J10"},         {"tms", "J14"},
              {"tdi", "H13"},        {"tdo", "H14"}};
  add(balls, "led", {"E21", "E22", "E25", "E24", "H21", "G20", "G22", "G21"});
  return balls;
}

Balls on_the_de2_70() {
  Balls balls{{"clock_50mhz", "AD15"}, {"clock_28mhz", "E16"}, {"uart_rxd", "D21"},
              {"uart_txd", "E21"},     {"tck", "G27"},         {"tms", "G28"},
              {"tdi", "H27"},          {"tdo", "L24"}};
  add(balls, "led", {"W27", "W25", "W23", "Y27", "Y24", "Y23", "AA27", "AA24"});
  return balls;
}

Balls on_the_ulx3s() {
  Balls balls{{"clk_25mhz", "G2"}, {"ftdi_txd", "M1"}, {"ftdi_rxd", "L4"},
              {"ftdi_ndtr", "N1"}, {"wifi_en", "F1"},  {"wifi_gpio0", "L2"}};
  add(balls, "led", {"B2", "C2", "C1", "D2", "D1", "E2", "E1", "H3"});
  return balls;
}

// What the printer of 2012 did not have, by position of J4, as the board's page has it.
const std::map<std::string, int> positions_since_2012{
    {"emergency_stop", 36},     {"heater_supply", 38},      {"sensor_resistor[1]", 16},
    {"sensor_resistor[2]", 18}, {"sensor_sense[1]", 20},    {"sensor_resistor[3]", 22},
    {"sensor_resistor[4]", 24}, {"sensor_resistor[5]", 26}, {"fan_gate", 14}};

struct Board {
  std::string device;
  // Columns of the package, and its last row of balls.
  int columns;
  std::string_view last_row;
  Balls balls;
  // What lies on it a board's page says, or the table of the printer of 2012.
  std::string_view header;
};

const std::map<std::string, Board> boards{
    {"de2_115", {"EP4CE115F29C7", 28, "AH", on_the_de2_115(), "de2_115_JP5_GPIO"}},
    {"de2_70", {"EP2C70F896C6", 30, "AK", on_the_de2_70(), "de2_70_J4_pin"}},
    {"de2_70_reprap_2012", {"EP2C70F896C6", 30, "AK", on_the_de2_70(), "de2_70_J4_pin"}},
    // A CABGA381, whose balls nextpnr knows: 20 columns, up to row Y.
    {"ulx3s", {"", 20, "Y", on_the_ulx3s(), ""}}};

// A, B, ... Y without the letters that look like others, then AA, AB, ...
int row_number(std::string_view row) {
  static constexpr std::string_view letters = "ABCDEFGHJKLMNPRTUVWY";
  int number = 0;
  for (const char letter : row) {
    const std::size_t place = letters.find(letter);
    if (place == std::string_view::npos) return 0;
    number = number * static_cast<int>(letters.size()) + static_cast<int>(place) + 1;
  }
  return number;
}

bool has_ball(const Board& board, const std::string& ball) {
  static const std::regex form("([A-Z]{1,2})([1-9][0-9]?)");
  std::smatch match;
  if (!std::regex_match(ball, match, form)) return false;
  const int row = row_number(match[1].str());
  return row > 0 && row <= row_number(board.last_row) && std::stoi(match[2]) <= board.columns;
}

class Comparison {
 public:
  Comparison(const std::filesystem::path& project, const std::string& name)
      : folder_(project / "boards" / name),
        board_(boards.at(name)),
        constraints_(generate_constraints(project, name)) {
    for (const Row& row : read_table(project / "boards/header40.csv")) {
      if (board_.header.empty()) break;
      const std::string& ball = row.at(std::string(board_.header));
      header_.insert(ball);
      for (const auto& [port, position] : positions_since_2012) {
        if (row.at("header_pin") == std::to_string(position)) since_2012_[port] = ball;
      }
    }
    if (!name.ends_with("_2012")) since_2012_.clear();
  }

  std::vector<std::string> run() {
    if (!constraints_.refusal.empty()) return {constraints_.refusal};
    for (const Row& row : read_table(folder_ / "pins.csv")) {
      const std::string& ball = row.at("pin");
      if (!has_ball(board_, ball)) {
        say(row.at("signal"), "is on " + ball + ", no ball of the device");
      }
    }
    for (const auto& [port, pin] : constraints_.pins) check(port, pin.site);
    if (!board_.device.empty()) {
      const std::vector<Row> properties = read_table(folder_ / "device.csv");
      const Row* device = row_with(properties, "property", "device");
      if (device == nullptr || device->at("value") != board_.device) {
        say("the board", "has another device: " + board_.device);
      }
    }
    return said_;
  }

 private:
  void say(const std::string& what, const std::string& how) { said_.push_back(what + " " + how); }

  void check(const std::string& port, const std::string& ball) {
    for (const Balls* balls : std::array<const Balls*, 2>{&board_.balls, &since_2012_}) {
      const auto place = balls->find(port);
      if (place == balls->end()) continue;
      if (place->second != ball) say(port, "is at " + ball + ", on the board at " + place->second);
      return;
    }
    const Row* row = row_with(pins_, "pin", ball);
    const bool on_header = board_.header.empty()
                               ? row != nullptr && row->at("signal").starts_with('g')
                               : header_.contains(ball);
    if (!on_header) say(port, "lies where nothing says what is there");
  }

  std::filesystem::path folder_;
  const Board& board_;
  Constraints constraints_;
  std::vector<Row> pins_ = read_table(folder_ / "pins.csv");
  std::set<std::string> header_;
  Balls since_2012_;
  std::vector<std::string> said_;
};

}  // namespace

std::vector<std::string> misplaced_in(const std::filesystem::path& project,
                                      const std::string& board) {
  return Comparison(project, board).run();
}

}  // namespace synthesis
