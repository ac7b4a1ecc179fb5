// SPDX-License-Identifier: Apache-2.0
// The nets of the interface board's parts that are destroyed, or destroy others, the wrong way
// round: written from their data sheets, not from the board's description.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <utility>

#include "directories.hpp"
#include "tests/wiring/made_files.hpp"

namespace {

using testing::Contains;
using testing::IsEmpty;
using wiring_files::Netlist;
using Places = std::vector<std::pair<std::string, std::string>>;  // pin and net

const Netlist& netlist() {
  static const Netlist list = wiring_files::read_netlist(std::filesystem::path(PROJECT_DIRECTORY) /
                                                         "boards/interface/interface.net");
  return list;
}

// A carrier of an A4988 by its pins: logic supply, coils, motor supply; ENABLE, micro-steps,
// RESET joined to SLEEP, STEP, DIR.
void add_carrier(Places& places, int axis) {
  const std::string driver = fmt::format("A1{}1.", axis), copy = std::to_string(axis);
  const std::vector<std::string> nets{"GND",
                                      "+3V3",
                                      "motor_" + copy + "_1b",
                                      "motor_" + copy + "_1a",
                                      "motor_" + copy + "_2a",
                                      "motor_" + copy + "_2b",
                                      "GND",
                                      "+12V",
                                      "motor_enable_n_" + copy,
                                      "+3V3",
                                      "+3V3",
                                      "+3V3",
                                      "driver_" + copy + "_reset",
                                      "driver_" + copy + "_reset",
                                      "driver_" + copy + "_step",
                                      "driver_" + copy + "_direction"};
  for (std::size_t pin = 0; pin < nets.size(); ++pin) {
    places.emplace_back(driver + std::to_string(pin + 1), nets[pin]);
  }
  // STEP and DIR of the same axis lead there through their resistors.
  places.emplace_back(fmt::format("R1{}1.1", axis), "step_" + copy);
  places.emplace_back(fmt::format("R1{}1.2", axis), "driver_" + copy + "_step");
  places.emplace_back(fmt::format("R1{}2.1", axis), "direction_" + copy);
  places.emplace_back(fmt::format("R1{}2.2", axis), "driver_" + copy + "_direction");
  // The motor's plug: one coil at 1 and 2, the other at 3 and 4.
  const std::string plug = fmt::format("J1{}1.", axis);
  for (const auto& [pin, coil] : Places{{"1", "2b"}, {"2", "2a"}, {"3", "1a"}, {"4", "1b"}}) {
    places.emplace_back(plug + pin, "motor_" + copy + "_" + coil);
  }
  places.emplace_back(fmt::format("C1{}1.1", axis), "+12V");
  places.emplace_back(fmt::format("C1{}1.2", axis), "GND");
}

Places places() {
  // Diodes: 1 is the cathode. BC337: 1 is the collector, 3 the emitter. DIN 72552: the coil's 86
  // is its +.
  Places all{{"D301.1", "+12V"},        {"D301.2", "relay_coil"}, {"D401.1", "+12V"},
             {"D401.2", "fan_low"},     {"D801.1", "+12V"},       {"D801.2", "GND"},
             {"C801.1", "+12V"},        {"C801.2", "GND"},        {"Q301.1", "relay_coil"},
             {"Q301.2", "relay_base"},  {"Q301.3", "GND"},        {"K301.86", "+12V"},
             {"K301.85", "relay_coil"}, {"K301.30", "+12V_IN"},   {"K301.87", "+HEAT"},
             {"Q401.1", "fan_mosfet"},  {"Q401.2", "fan_low"},    {"Q401.3", "GND"},
             {"J801.1", "+12V_IN"},     {"J801.2", "GND"},        {"F801.1", "+12V_IN"},
             {"F801.2", "+12V"}};
  for (int axis = 0; axis < 5; ++axis) add_carrier(all, axis);
  for (const std::string heater : {"0", "1"}) {
    for (const std::string mosfet : {"1", "2"}) {
      const std::string q = "Q2" + heater + mosfet;
      all.emplace_back(q + ".1", "heater_" + heater + "_gate");
      all.emplace_back(q + ".2", "heater_" + heater + "_low");
      all.emplace_back(q + ".3", "GND");
    }
  }
  return all;
}

std::vector<std::string> wrong_pins(const Netlist& list) {
  std::vector<std::string> found;
  for (const auto& [pin, net] : places()) {
    if (list.net_of(pin) != net) found.push_back(pin);
  }
  return found;
}

Netlist with_exchanged(const std::string& one, const std::string& other) {
  Netlist list = netlist();
  const std::string first = list.net_of(one), second = list.net_of(other);
  list.pins.at(first).erase(one);
  list.pins.at(first).insert(other);
  list.pins.at(second).erase(other);
  list.pins.at(second).insert(one);
  return list;
}

TEST(InterfaceBoard, connects_each_pin_that_must_not_be_reversed) {
  EXPECT_THAT(wrong_pins(netlist()), IsEmpty());
}

TEST(InterfaceBoard, with_two_pins_exchanged_is_found) {
  for (const auto& [one, other] : Places{{"A101.2", "A101.8"},
                                         {"A121.15", "A121.16"},
                                         {"A131.9", "A131.13"},
                                         {"D301.1", "D301.2"},
                                         {"D401.1", "D401.2"},
                                         {"D801.1", "D801.2"},
                                         {"C111.1", "C111.2"},
                                         {"C801.1", "C801.2"},
                                         {"Q301.1", "Q301.3"},
                                         {"K301.85", "K301.86"},
                                         {"J141.2", "J141.3"},
                                         {"Q212.2", "Q212.3"},
                                         {"R101.1", "R111.1"}}) {
    EXPECT_THAT(wrong_pins(with_exchanged(one, other)), Contains(one)) << one << " and " << other;
  }
}

}  // namespace
