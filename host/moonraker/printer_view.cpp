// SPDX-License-Identifier: Apache-2.0
// States and words of Klipper, made of the spooler's snapshot.
#include "host/moonraker/printer_view.hpp"

#include <algorithm>
#include <chrono>

#include "host/moonraker/configuration.hpp"

namespace moonraker {

namespace {

std::int64_t now_ms() {
  return std::chrono::duration_cast<std::chrono::milliseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

bool is_over(const Json& job) {
  const auto state = queue::state_named(job.at("state").get<std::string>()).value();
  return queue::is_final(state) || state == queue::JobState::interrupted;
}

// Held jobs wait for something else than the bed.
bool waits_for(const Json& job, const std::string& printer) {
  const std::string state = job.at("state"), wanted = job.at("wanted_printer");
  const bool waits = state == "queued" || state == "uploaded" || state == "checking";
  return waits && !job.at("held").get<bool>() && (wanted.empty() || wanted == printer);
}

}  // namespace

JobTimes times_of(const std::vector<queue::Change>& history, std::int64_t now_ms) {
  JobTimes times;
  std::int64_t began = 0, printing_since = 0, printing = 0, ended = 0;
  for (const queue::Change& change : history) {
    if (change.to == queue::JobState::starting) began = printing = ended = 0;
    if (change.from == queue::JobState::printing && printing_since != 0) {
      printing += change.time_ms - printing_since;
      printing_since = 0;
    }
    if (change.to == queue::JobState::printing) {
      if (began == 0) began = change.time_ms;
      printing_since = change.time_ms;
    }
    if (!queue::is_active(change.to)) ended = change.time_ms;
  }
  if (began == 0) return times;
  if (printing_since != 0) printing += now_ms - printing_since;
  times.started = static_cast<double>(began) / 1000;
  times.ended = static_cast<double>(ended) / 1000;
  times.total = static_cast<double>((ended != 0 ? ended : now_ms) - began) / 1000;
  times.printing = static_cast<double>(printing) / 1000;
  return times;
}

PrinterView view_of(spooler::Spooler& spooler, const std::string& printer) {
  const auto snapshot = spooler.snapshot();
  const Json& printers = snapshot->json.at("printers");
  const auto found =
      std::ranges::find_if(printers, [&](const Json& each) { return each.at("name") == printer; });
  if (found == printers.end()) throw spooler::NoSuchPrinter(printer);
  Json shown, waiting;
  for (const Json& job : snapshot->json.at("jobs")) {
    if (waiting.is_null() && waits_for(job, printer)) waiting = job;
    if (job.at("printer") != printer) continue;
    const bool is_active = job.at("id") == found->at("job");
    const bool is_later = shown.is_null() || job.at("changed_ms") > shown.at("changed_ms");
    if (is_active || (found->at("job").is_null() && is_over(job) && is_later)) shown = job;
  }
  JobTimes times;
  try {
    if (!shown.is_null()) times = times_of(spooler.history(shown.at("id")), now_ms());
  } catch (const queue::NoSuchJob&) {  // removed since the snapshot
  }
  return {*found, std::move(shown), std::move(waiting), times};
}

// The printer answers nothing after M112, until it is reset.
bool PrinterView::was_stopped() const {
  const Json& console = printer_.at("console");
  for (auto line = console.rbegin(); line != console.rend(); ++line) {
    const std::string text = line->at("text");
    if (text == "start") return false;
    if (text == "> M112") return true;
  }
  return false;
}

std::string_view PrinterView::klippy_state() const {
  const std::string link = printer_.at("link");
  if (link == "ready") return "ready";
  if (link != "asking") return "disconnected";
  return was_stopped() ? "shutdown" : "startup";
}

std::string PrinterView::klippy_message() const {
  const std::string fault = printer_.at("fault");
  if (!fault.empty()) return fault;
  const std::string_view state = klippy_state();
  if (state == "ready") return "Printer is ready";
  if (state == "shutdown") return "Stopped by M112: reset the printer (FIRMWARE_RESTART)";
  if (state == "startup") return "The printer does not answer yet";
  return "The printer's port is not open";
}

std::string_view PrinterView::print_state() const {
  if (job_.is_null()) return "standby";
  const std::string state = job_.at("state");
  if (is_active_) return state == "paused" ? "paused" : "printing";
  if (bed_is_clear()) {
    return "standby";  // the last print has been taken off
  }
  if (state == "finished") return "complete";
  return state == "cancelled" ? "cancelled" : "error";
}

std::string PrinterView::message() const {
  const std::string_view state = print_state();
  if (state == "printing" || state == "paused") {
    if (printer_.at("phase") == "cancelling") return "Switching everything off";
    return printer_.at("waits_for_user") ? "The printer waits for a person: RESUME" : "";
  }
  std::string text;
  if (state == "error") {
    text = "Job " + job_.at("id").dump() + ": " + job_.at("reason").get<std::string>();
  }
  if (waiting_.is_null()) return text;
  if (!text.empty()) text += ". ";
  const std::string job =
      "Job " + waiting_.at("id").dump() + " (" + waiting_.at("name").get<std::string>() + ")";
  if (!bed_is_clear()) return text + job + " waits until the bed is clear: confirm it by BED_CLEAR";
  const auto& left = printer_.at("filament_mm");
  if (!left.is_null() && waiting_.at("filament_mm") > left) {
    return text + job + " waits for more filament: say in the spooler's page how much there is";
  }
  if (waiting_.at("state") != "queued") return text + job + " is being checked";
  return text + job + " starts when the printer is ready";
}

double PrinterView::progress() const {
  const double commands = job_.is_null() ? 0.0 : job_.at("commands").get<double>();
  if (commands <= 0) return 0;
  if (job_.at("state") == "finished") return 1;
  const bool is_known = is_active_ || printer_.at("feeder_job") == job_.at("id");
  return is_known ? std::clamp(printer_.at("done").get<double>() / commands, 0.0, 1.0) : 0;
}

Json PrinterView::print_stats() const {
  Json stats{{"state", print_state()},
             {"message", message()},
             {"filename", ""},
             {"total_duration", 0.0},
             {"print_duration", 0.0},
             {"filament_used", 0.0},
             {"info", {{"total_layer", nullptr}, {"current_layer", nullptr}}}};
  if (job_.is_null() || print_state() == "standby") return stats;
  stats["filename"] = job_.at("name");
  stats["total_duration"] = times_.total;
  stats["print_duration"] = times_.printing;
  stats["filament_used"] = job_.at("filament_mm").get<double>() * progress();
  return stats;
}

Json PrinterView::virtual_sdcard() const {
  Json card{{"progress", 0.0},
            {"is_active", print_state() == "printing"},
            {"file_position", 0},
            {"file_size", 0},
            {"file_path", nullptr}};
  if (job_.is_null() || print_state() == "standby") return card;
  const auto bytes = job_.at("bytes").get<std::int64_t>();
  card["progress"] = progress();
  card["file_position"] = static_cast<std::int64_t>(static_cast<double>(bytes) * progress());
  card["file_size"] = bytes;
  card["file_path"] = job_.at("name");
  return card;
}

Json PrinterView::objects() const {
  const std::string_view state = klippy_state();
  const bool is_printing = print_state() == "printing";
  Json all{
      {"webhooks",
       // Klipper itself is never disconnected.
       {{"state", state == "disconnected" ? "startup" : state},
        {"state_message", klippy_message()}}},
      {"configfile", configfile()},
      {"print_stats", print_stats()},
      {"virtual_sdcard", virtual_sdcard()},
      {"pause_resume", {{"is_paused", print_state() == "paused"}}},
      {"idle_timeout",
       {{"state", is_printing ? "Printing" : "Ready"},
        {"printing_time", is_printing ? times_.total : 0}}},
      {"display_status", {{"progress", is_active_ ? progress() : 0.0}, {"message", message()}}},
      {"heaters",
       {{"available_heaters", {"extruder", "heater_bed"}},
        {"available_sensors", {"extruder", "heater_bed"}}}}};
  for (const auto& [name, ours] :
       {std::pair{"extruder", "hotend"}, std::pair{"heater_bed", "bed"}}) {
    Json heater = Json::object();
    const Json& pair = printer_.at(ours);
    if (!pair.at(0).is_null()) heater["temperature"] = pair.at(0);
    if (!pair.at(1).is_null()) heater["target"] = pair.at(1);
    if (pair.size() > 2 && !pair.at(2).is_null()) heater["power"] = pair.at(2);
    all[name] = heater;
  }
  for (const Macro& macro : macros()) {
    all["gcode_macro " + std::string(macro.name)] = Json::object();
  }
  all.update(motion());
  return all;
}

Json PrinterView::motion() const {
  Json toolhead{{"extruder", "extruder"}, {"print_time", times_.printing}};
  Json moves{{"homing_origin", {0.0, 0.0, 0.0, 0.0}}};
  Json report = Json::object();
  toolhead["homed_axes"] = printer_.at("homed");
  const auto position = printer_.find("position");
  if (position != printer_.end() && position->is_object()) {
    const Json& places = position->at("mm");
    toolhead["position"] = moves["position"] = moves["gcode_position"] = places;
    report["live_position"] = places;
  }
  return {{"toolhead", toolhead}, {"gcode_move", moves}, {"motion_report", report}};
}

}  // namespace moonraker
