// SPDX-License-Identifier: Apache-2.0
// printer: information, prints, G-code, emergency stop.
#include <unistd.h>

#include <array>

#include "host/moonraker/configuration.hpp"
#include "host/moonraker/core.hpp"
#include "host/moonraker/method_tables.hpp"
#include "host/moonraker/script.hpp"
#include "host/moonraker/versions.hpp"

namespace moonraker {

namespace {

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

Json info(Core& core, const Json&, Connection*) {
  const PrinterView view = core.view();
  return {{"state", view.klippy_state()},
          {"state_message", view.klippy_message()},
          {"hostname", host_name()},
          {"app", "StepFabric"},
          {"software_version", std::string("v") + stepfabric_version},
          {"cpu_info", ""}};
}

Json asked(Core& core, const char* what) {
  core.spooler.ask(core.printer, {{"do", what}});
  return "ok";
}
Json pause(Core& core, const Json&, Connection*) { return asked(core, "pause"); }
Json resume(Core& core, const Json&, Connection*) { return asked(core, "resume"); }
Json cancel(Core& core, const Json&, Connection*) { return asked(core, "cancel"); }
Json stop(Core& core, const Json&, Connection*) { return asked(core, "stop"); }

Json start(Core& core, const Json& params, Connection*) {
  const std::string awaited = print_file(core, text_in(params, "filename"));
  core.hub.broadcast(notification("notify_gcode_response", Json::array({"// " + awaited})));
  return "ok";
}

Json script(Core& core, const Json& params, Connection*) {
  run_script(core, text_in(params, "script"));
  return "ok";
}

Json restart(Core& core, const Json&, Connection*) {
  core.spooler.restart(core.printer);
  return "ok";
}

Json help(Core&, const Json&, Connection*) {
  Json all = Json::object();
  for (const auto& table : {macros(), other_commands()}) {
    for (const Macro& macro : table) all[std::string(macro.name)] = macro.help;
  }
  return all;
}

Json end_stops(Core&, const Json&, Connection*) {
  throw Error(400, "send M119: its answer is in the console");
}

}  // namespace

std::vector<Method> printer_methods() {
  return {{"printer.info", "GET", "/printer/info", info},
          {"printer.print.start", "POST", "/printer/print/start", start},
          {"printer.print.pause", "POST", "/printer/print/pause", pause},
          {"printer.print.resume", "POST", "/printer/print/resume", resume},
          {"printer.print.cancel", "POST", "/printer/print/cancel", cancel},
          {"printer.emergency_stop", "POST", "/printer/emergency_stop", stop},
          {"printer.restart", "POST", "/printer/restart", restart},
          {"printer.firmware_restart", "POST", "/printer/firmware_restart", restart},
          {"printer.gcode.script", "POST", "/printer/gcode/script", script},
          {"printer.gcode.help", "GET", "/printer/gcode/help", help},
          {"printer.query_endstops.status", "GET", "/printer/query_endstops/status", end_stops}};
}

}  // namespace moonraker
