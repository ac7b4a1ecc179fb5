// SPDX-License-Identifier: Apache-2.0
// Every pin of every board has the pull, drive, slew and voltage that its signal needs, and is
// wired as its page says.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "directories.hpp"
#include "tests/synthesis/board_pins.hpp"
#include "tests/synthesis/pin_needs.hpp"
#include "tests/synthesis/pin_places.hpp"

namespace synthesis {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

const fs::path project = PROJECT_DIRECTORY;

TEST(Pins, of_every_board_are_as_their_signals_need_and_where_the_board_has_them) {
  int boards = 0;
  for (const auto& folder : fs::directory_iterator(project / "boards")) {
    const std::string board = folder.path().filename().string();
    // The core alone is placed without pins; the others with a top entity go onto a board.
    if (board == "core" || !fs::exists(folder.path() / (board + ".vhd"))) continue;
    EXPECT_THAT(shortcomings_of(project, board), IsEmpty()) << board;
    EXPECT_THAT(misplaced_in(project, board), IsEmpty()) << board;
    ++boards;
  }
  EXPECT_GE(boards, 4);
}

// A row of a page's wiring table: the signals, their places on the header,
// what to connect.
struct Wiring {
  std::vector<std::string> header;
  std::string connect;
};

std::map<std::string, Wiring> wiring_of(const fs::path& page) {
  static const std::regex row(R"(\| ((`\w+` ?)+) \|(( (G[PN])?\d+)+) \| (.*) \|)");
  std::map<std::string, Wiring> wirings;
  std::ifstream stream(page);
  std::string line;
  while (std::getline(stream, line)) {
    std::smatch match;
    if (!std::regex_match(line, match, row)) continue;
    std::istringstream places(match[3]);
    const std::vector<std::string> header{std::istream_iterator<std::string>(places), {}};
    std::string names = match[1];
    std::erase(names, '`');
    std::istringstream words(names);
    const std::vector<std::string> signals{std::istream_iterator<std::string>(words), {}};
    for (std::size_t i = 0; i < signals.size(); ++i) {
      wirings[signals[i]] = {signals.size() == 1 ? header : std::vector{header.at(i)}, match[6]};
    }
  }
  return wirings;
}

using Headers = std::map<std::string, std::vector<std::string>>;

void expect_wired(const std::map<std::string, Wiring>& wirings, const Headers& headers) {
  EXPECT_EQ(wirings.size(), headers.size());
  for (const auto& [signal, header] : headers) {
    ASSERT_TRUE(wirings.contains(signal)) << signal;
    EXPECT_EQ(wirings.at(signal).header, header) << signal;
  }
  for (const Row& row : read_table(project / "constraints/signals.csv")) {
    if (row.at("outside").empty() || !headers.contains(row.at("port"))) continue;
    const std::string& connect = wirings.at(row.at("port")).connect;
    const double kiloohms = std::stod(row.at("outside_ohms")) / 1'000;
    EXPECT_THAT(connect, HasSubstr(fmt::format("{:g} kΩ to {}", kiloohms,
                                               row.at("outside") == "up" ? "3.3 V" : "ground")));
  }
}

TEST(Pins, of_the_ulx3s_are_wired_as_its_page_says) {
  Headers headers;
  for (const Row& row : read_table(project / "boards/ulx3s/connections.csv")) {
    static const std::regex place(R"(g([pn])\[(\d+)\])");
    std::smatch match;
    if (!std::regex_match(row.at("signal"), match, place)) continue;
    headers[signal_of(row.at("port"))].push_back((match[1] == "p" ? "GP" : "GN") + match[2].str());
  }
  expect_wired(wiring_of(project / "boards/ulx3s/README.md"), headers);
}

// Both at the same positions of the 40-pin header, so that one interface board serves both.
TEST(Pins, of_the_boards_with_a_cyclone_are_wired_as_their_page_says) {
  const auto wirings = wiring_of(project / "boards/cyclone/README.md");
  for (const auto& [board, column] :
       {std::pair{"de2_115", "de2_115_JP5_GPIO"}, std::pair{"de2_70", "de2_70_J4_pin"}}) {
    const fs::path folder = project / "boards" / board;
    std::map<std::string, std::string> pins, positions;
    for (const Row& row : read_table(folder / "pins.csv")) pins[row.at("signal")] = row.at("pin");
    for (const Row& row : read_table(project / "boards/header40.csv")) {
      positions[row.at(column)] = row.at("header_pin");
    }
    Headers headers;
    for (const Row& row : read_table(folder / "connections.csv")) {
      const auto position = positions.find(pins.at(row.at("signal")));
      if (position == positions.end()) continue;
      headers[signal_of(row.at("port"))].push_back(position->second);
    }
    SCOPED_TRACE(board);
    expect_wired(wirings, headers);
  }
}

// What each signal of the printer of 2012 was called, and is now.
const std::map<std::string, std::string> signals_of_2012{{"M1(E)_step", "step[3]"},
                                                         {"M1(E)_dir", "direction[3]"},
                                                         {"M1(E)_reset", "motor_reset_n[3]"},
                                                         {"M2(X)_step", "step[0]"},
                                                         {"M2(X)_dir", "direction[0]"},
                                                         {"M2(X)_reset", "motor_reset_n[0]"},
                                                         {"M3(Y)_step", "step[1]"},
                                                         {"M3(Y)_dir", "direction[1]"},
                                                         {"M3(Y)_reset", "motor_reset_n[1]"},
                                                         {"M4(Za)_step", "step[2]"},
                                                         {"M4(Za)_dir", "direction[2]"},
                                                         {"M4(Za)_reset", "motor_reset_n[2]"},
                                                         {"M5(Zb)_step", "step[4]"},
                                                         {"M5(Zb)_dir", "direction[4]"},
                                                         {"M5(Zb)_reset", "motor_reset_n[4]"},
                                                         {"endstop1(Z)", "end_stop[2]"},
                                                         {"endstop2(Y)", "end_stop[1]"},
                                                         {"endstop3(X)", "end_stop[0]"},
                                                         {"heater1", "heater_gate[0]"},
                                                         {"heater2", "heater_gate[1]"},
                                                         {"rc_adc_sense", "sensor_sense[0]"},
                                                         {"rc_adc_drive", "sensor_resistor[0]"},
                                                         {"uart_rxd", "uart_rxd"},
                                                         {"uart_txd", "uart_txd"},
                                                         {"clk50", "clock_50mhz"}};

TEST(Pins, of_the_printer_of_2012_are_where_they_were) {
  const Constraints constraints = generate_constraints(project, "de2_70_reprap_2012");
  ASSERT_EQ(constraints.refusal, "");
  const std::vector<Row> rows = read_table(project / "boards/de2_70/reprap_2012_pins.csv");
  EXPECT_EQ(rows.size(), signals_of_2012.size());
  for (const Row& row : rows) {
    const std::string& port = signals_of_2012.at(row.at("signal"));
    EXPECT_EQ(constraints.pins.at(port).site, row.at("pin")) << port;
  }
}

// nextpnr's own data base says in which bank a pin lies.
TEST(Pins, of_the_ulx3s_lie_in_the_banks_of_its_table) {
  for (const char* device : {"LFE5U-25F", "LFE5U-45F", "LFE5U-85F"}) {
    const fs::path file = fs::path("/usr/share/trellis/database/ECP5") / device / "iodb.json";
    if (!fs::exists(file)) GTEST_SKIP() << "fpga-trellis is not installed";
    const auto data = nlohmann::json::parse(std::ifstream(file));
    std::map<std::array<int, 2>, std::map<std::string, int>> banks;
    for (const auto& pio : data.at("pio_metadata")) {
      banks[{pio.at("row"), pio.at("col")}][pio.at("pio")] = pio.at("bank");
    }
    const auto& package = data.at("packages").at("CABGA381");
    for (const Row& row : read_table(project / "boards/ulx3s/pins.csv")) {
      // The flash's clock is no pin for users.
      if (row.at("signal") == "flash_clk") continue;
      const auto& place = package.at(row.at("pin"));
      const int bank = banks.at({place.at("row"), place.at("col")}).at(place.at("pio"));
      EXPECT_EQ(row.at("bank"), std::to_string(bank)) << row.at("signal") << " of " << device;
    }
  }
}

}  // namespace
}  // namespace synthesis
