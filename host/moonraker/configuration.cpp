// SPDX-License-Identifier: Apache-2.0
// Sections by name, in lower case.
#include "host/moonraker/configuration.hpp"

#include <array>
#include <string>

namespace moonraker {

using Json = nlohmann::json;

namespace {

constexpr std::array table{
    Macro{"BED_CLEAR", "Confirms that the bed is clear: the next job may start"},
    Macro{"PAUSE", "Pauses the print"}, Macro{"RESUME", "Goes on after a pause"},
    Macro{"CANCEL_PRINT", "Ends the print and switches everything off"}};

constexpr std::array others{Macro{"SET_HEATER_TEMPERATURE", "HEATER=extruder|heater_bed TARGET=C"},
                            Macro{"TURN_OFF_HEATERS", "Switches both heaters off"},
                            Macro{"SDCARD_PRINT_FILE", "FILENAME=NAME: queues the file"},
                            Macro{"FIRMWARE_RESTART", "Switches a simulated printer off and on"},
                            Macro{"RESTART", "The same"}};

Json made() {
  Json settings{{"printer", {{"kinematics", "cartesian"}}},
                {"virtual_sdcard", {{"path", "gcodes"}}},
                {"pause_resume", Json::object()},
                {"display_status", Json::object()},
                {"extruder", Json::object()},
                {"heater_bed", Json::object()}};
  for (const Macro& macro : table) {
    std::string name(macro.name);
    for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    settings["gcode_macro " + name] = {{"gcode", ""}, {"description", macro.help}};
  }
  return {{"settings", settings},
          {"config", settings},
          {"warnings", Json::array()},
          {"save_config_pending", false},
          {"save_config_pending_items", Json::object()}};
}

}  // namespace

std::span<const Macro> macros() { return table; }
std::span<const Macro> other_commands() { return others; }

const Json& configfile() {
  static const Json json = made();
  return json;
}

}  // namespace moonraker
