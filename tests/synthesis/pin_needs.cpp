// SPDX-License-Identifier: Apache-2.0
// What the circuit behind each signal needs of its pin. This is known here from the circuit, not
// read from constraints/signals.csv, which it judges.
#include "tests/synthesis/pin_needs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <regex>
#include <set>
#include <string_view>

#include "tests/synthesis/board_pins.hpp"
#include "tools/files/file_text.hpp"

namespace synthesis {
namespace {

constexpr double supply_volts = 3.3;
// An ECP5's own pulls at 3.3 V: 30 to 150 uA (FPGA-DS-02012). Before it is configured they may
// pull either way.
constexpr double strongest_ecp5_pull_ohms = 22e3;
// A Cyclone's, which pull up only: from 7 kOhm on (Cyclone IV device data sheet, R_PU).
constexpr double strongest_cyclone_pull_ohms = 7e3;
// A logic-level MOSFET may begin to conduct at 1 V.
constexpr double gate_off_volts = 0.8;
// A4988, DRV8825 and TMC2209 read 0.7 of their logic supply as high.
constexpr double driver_high_volts = 0.7 * supply_volts;
// The low reference takes 3.3 V over 470 Ohm.
constexpr int sensor_drive_ma = 8;

struct Kind {
  std::string_view direction;
  std::string_view pull;
  int least_drive_ma = 0;
  int most_drive_ma = 0;
  // What holds the signal while the FPGA does not: up, down, or nothing.
  std::string_view outside{};
  // What drives power, or must keep its distance to another signal, comes from a register
  // in its pad.
  bool registered = false;
  // Of a lamp on the board: 2.5 V will do.
  bool any_volts = false;
  // Its frequency in MHz is in its name.
  bool is_clock = false;
};

constexpr Kind oscillator{"in", "NONE", 0, 0, "", false, false, true};
constexpr Kind rests_high{"in", "UP"};
constexpr Kind rests_low{"in", "DOWN"};
constexpr Kind fail_safe{"in", "UP", 0, 0, "up"};
constexpr Kind on_the_board{"out", "NONE", 4, 8};
constexpr Kind lamp{"out", "NONE", 4, 8, "", false, true};
constexpr Kind over_a_cable{"out", "NONE", 8, 8, "", true};
constexpr Kind held_high{"out", "UP", 4, 8, "up", true};
// Its driver reads less than 0.3 of its supply as low, which is more than a gate may have.
constexpr Kind held_in_reset{"out", "DOWN", 4, 8, "down", true};
constexpr Kind held_low{"out", "DOWN", 8, 8, "down", true};
// Must open without the clock that a register in the pad would need.
constexpr Kind opens_without_a_clock{"out", "DOWN", 8, 8, "down"};
constexpr Kind sensor_drive{"out", "NONE", sensor_drive_ma, 16};
constexpr Kind sensor_input{"in", "NONE"};

struct Need {
  std::string_view signal;
  Kind kind;
};

constexpr std::array needs{Need{"clk_25mhz", oscillator},
                           Need{"clock_50mhz", oscillator},
                           Need{"clock_25mhz", oscillator},
                           Need{"clock_28mhz", oscillator},
                           Need{"uart_rxd", rests_high},
                           Need{"uart_txd", on_the_board},
                           Need{"ftdi_txd", rests_high},
                           Need{"ftdi_rxd", on_the_board},
                           Need{"ftdi_ndtr", rests_high},
                           Need{"wifi_en", on_the_board},
                           Need{"wifi_gpio0", on_the_board},
                           Need{"led", lamp},
                           Need{"emergency_stop", fail_safe},
                           Need{"motion_start", rests_low},
                           Need{"end_stop", rests_high},
                           Need{"step", over_a_cable},
                           Need{"direction", over_a_cable},
                           Need{"motor_enable_n", held_high},
                           Need{"motor_reset_n", held_in_reset},
                           Need{"heater_gate", held_low},
                           Need{"heater_supply", opens_without_a_clock},
                           Need{"fan_gate", held_low},
                           Need{"sensor_resistor", sensor_drive},
                           Need{"sensor_sense", sensor_input},
                           Need{"tck", rests_high},
                           Need{"tms", rests_high},
                           Need{"tdi", rests_high},
                           Need{"tdo", on_the_board}};

class Check {
 public:
  Check(const std::filesystem::path& project, const std::string& board)
      : constraints_(generate_constraints(project, board)),
        ports_(ports_of(project / "boards" / board / (board + ".vhd"))),
        signals_(read_table(project / "constraints/signals.csv")),
        pins_(read_table(project / "boards" / board / "pins.csv")),
        banks_(read_table(project / "boards" / board / "banks.csv")),
        is_cyclone_(std::filesystem::exists(project / "boards" / board / "device.csv")),
        timing_(is_cyclone_ ? "" : files::text_of(project / "constraints" / (board + ".lpf"))) {}

  std::vector<std::string> run() {
    if (!constraints_.refusal.empty()) return {constraints_.refusal};
    for (const auto& [port, direction] : ports_) {
      if (!constraints_.pins.contains(port)) say(port, "has no pin");
    }
    for (const auto& [port, pin] : constraints_.pins) check(port, pin);
    return said_;
  }

 private:
  void say(const std::string& port, const std::string& what) { said_.push_back(port + " " + what); }

  void check(const std::string& port, const ConstrainedPin& pin) {
    const auto* need = std::ranges::find(needs, signal_of(port), &Need::signal);
    if (need == needs.end()) return say(port, "is not known to this test");
    const auto entity_port = ports_.find(port);
    if (entity_port == ports_.end()) return say(port, "is no port of the top entity");
    if (entity_port->second != need->kind.direction) say(port, "has the wrong direction");
    is_cyclone_ ? check_cyclone_buffer(port, pin, need->kind) : check_buffer(port, pin, need->kind);
    check_place(port, pin, need->kind);
    check_table(port, need->kind.outside, need->kind.registered);
    if (need->kind.is_clock && !is_cyclone_) check_frequency(port);
  }

  // nextpnr takes 12 MHz for a clock that has none. (What Quartus gets, check_project.tcl checks.)
  void check_frequency(const std::string& port) {
    static const std::regex constraint("(?:^|\\n)FREQUENCY PORT \"(\\w+)\" ([0-9.]+) MHZ;"),
        mhz("\\d+(?=mhz)");
    std::smatch wanted;
    std::regex_search(port, wanted, mhz);
    int times = 0;
    for (std::sregex_iterator at(timing_.begin(), timing_.end(), constraint), end; at != end;
         ++at) {
      if ((*at)[1] != port) continue;
      if (std::stod((*at)[2]) != std::stod(wanted[0])) {
        say(port, "is constrained to another frequency");
      }
      ++times;
    }
    if (times != 1) say(port, fmt::format("has {} timing constraints", times));
  }

  void check_buffer(const std::string& port, const ConstrainedPin& pin, const Kind& kind) {
    std::map<std::string, std::string> attributes = pin.attributes;
    if (attributes["IO_TYPE"] != "LVCMOS33") say(port, "is not at 3.3 V");
    if (attributes["PULLMODE"] != kind.pull) {
      say(port, fmt::format("has pull {}, needs {}", attributes["PULLMODE"], kind.pull));
    }
    const std::string drive = attributes["DRIVE"];
    if (kind.direction == "in") {
      if (!drive.empty() || !attributes["SLEWRATE"].empty()) say(port, "is driven");
      return;
    }
    check_drive(port, drive, kind);
    // The fastest signal is a step's pulse of a microsecond: nothing here needs a fast edge.
    if (attributes["SLEWRATE"] != "SLOW") say(port, "has edges that ring");
  }

  // An output is driven from the configuration on, and has no pull; there is no choice of slew.
  void check_cyclone_buffer(const std::string& port, const ConstrainedPin& pin, const Kind& kind) {
    std::map<std::string, std::string> attributes = pin.attributes;
    const std::string standard = attributes["IO_STANDARD"];
    if (standard != "3.3-V LVTTL" && !(kind.any_volts && standard == "2.5 V")) {
      say(port, "is not at 3.3 V");
    }
    const bool is_input = kind.direction == "in", is_pulled = is_input && kind.pull != "NONE";
    const std::string pull = attributes["WEAK_PULL_UP_RESISTOR"];
    if (kind.pull == "DOWN" && is_input) say(port, "needs a pull-down, which there is not");
    if (pull != (is_pulled ? "ON" : "")) say(port, "has pull-up " + pull);
    if ((attributes["FAST_OUTPUT_REGISTER"] == "ON") != kind.registered) {
      say(port, "has its register elsewhere");
    }
    const std::string drive = attributes["CURRENT_STRENGTH_NEW"];
    if (!is_input) return check_drive(port, drive, kind);
    if (!drive.empty()) say(port, "is driven");
  }

  void check_drive(const std::string& port, const std::string& drive, const Kind& kind) {
    const int drive_ma = drive.empty() ? 0 : std::stoi(drive);
    if (drive_ma < kind.least_drive_ma || drive_ma > kind.most_drive_ma) {
      say(port, fmt::format("drives {} mA, needs {} to {}", drive_ma, kind.least_drive_ma,
                            kind.most_drive_ma));
    }
  }

  void check_place(const std::string& port, const ConstrainedPin& pin, const Kind& kind) {
    if (!sites_.insert(pin.site).second) say(port, "shares its pin with another port");
    const Row* place = row_with(pins_, "pin", pin.site);
    if (place == nullptr) return say(port, "lies on no pin of the board");
    const Row* bank = row_with(banks_, "bank", place->at("bank"));
    if (bank == nullptr || (std::stod(bank->at("volts")) != supply_volts && !kind.any_volts)) {
      say(port, "lies in a bank of another voltage");
    }
    const bool is_clock_input = place->at("shared_with") == "clock_input";
    if (is_clock_input && (kind.direction != "in" || kind.pull != "NONE")) {
      say(port, "lies on a clock input, which neither drives nor pulls");
    }
    if (place->at("shared_with") == "wifi") say(port, "can be driven by the radio module too");
  }

  // The resistor outside holds its level against the strongest pull of an FPGA without contents.
  void check_table(const std::string& port, std::string_view wanted, bool registered) {
    const Row* signal = row_with(signals_, "port", signal_of(port));
    if ((signal->at("register") == "pad") != registered) say(port, "has its register elsewhere");
    if (signal->at("outside") != wanted) return say(port, "needs another resistor outside");
    if (wanted.empty()) return;
    const double ohms = std::stod("0" + signal->at("outside_ohms"));
    const double strongest_pull_ohms =
        is_cyclone_ ? strongest_cyclone_pull_ohms : strongest_ecp5_pull_ohms;
    const double error_volts =
        wanted == "up" && is_cyclone_ ? 0 : supply_volts * ohms / (ohms + strongest_pull_ohms);
    const bool holds = wanted == "down" ? error_volts < gate_off_volts
                                        : supply_volts - error_volts > driver_high_volts;
    if (!holds || ohms < 1'000) say(port, "has a wrong resistor outside");
  }

  Constraints constraints_;
  std::map<std::string, std::string> ports_;
  std::vector<Row> signals_, pins_, banks_;
  std::set<std::string> sites_;
  bool is_cyclone_;
  std::string timing_;
  std::vector<std::string> said_;
};

}  // namespace

std::vector<std::string> shortcomings_of(const std::filesystem::path& project,
                                         const std::string& board) {
  return Check(project, board).run();
}

}  // namespace synthesis
