// SPDX-License-Identifier: Apache-2.0
// The shapes of OctoPrint's answers; states have its words.
#include "host/web/octoprint_answers.hpp"

#include <algorithm>
#include <cmath>

#include "host/web/version.hpp"

namespace web::octoprint {

namespace {

Json file_json(const std::string& name, const Json& bytes, const Json& uploaded_ms) {
  return {{"name", name},
          {"path", name},
          {"display", name},
          {"origin", "local"},
          {"type", "machinecode"},
          {"typePath", {"machinecode", "gcode"}},
          {"size", bytes},
          {"date", uploaded_ms.is_null() ? Json() : Json(uploaded_ms.get<std::int64_t>() / 1000)}};
}

Json heater(const Json& pair) {
  return {{"actual", pair.at(0)}, {"target", pair.at(1)}, {"offset", 0}};
}

}  // namespace

Json user() {
  return {{"name", "stepfabric"}, {"active", true},    {"admin", true},
          {"user", true},         {"apikey", nullptr}, {"groups", {"admins", "users"}},
          {"session", "none"}};
}

std::map<std::string, Json> fixed_answers() {
  const Json profile{
      {"id", "_default"},       {"name", "StepFabric"},
      {"model", "StepFabric"},  {"default", true},
      {"current", true},        {"heatedBed", true},
      {"heatedChamber", false}, {"extruder", {{"count", 1}, {"sharedNozzle", false}}}};
  return {{"version",
           {{"api", "0.1"},
            {"server", octoprint_version},
            {"text", std::string("OctoPrint (StepFabric ") + stepfabric_version + ")"},
            {"capabilities", {{"upload-by-put", true}}}}},  // of PrusaLink
          {"server", {{"version", octoprint_version}, {"safemode", nullptr}}},
          {"currentuser", {{"name", "stepfabric"}, {"groups", {"admins", "users"}}}},
          {"settings",
           {{"feature", {{"sdSupport", false}}},
            {"webcam", {{"webcamEnabled", false}, {"streamUrl", ""}, {"snapshotUrl", ""}}},
            {"plugins", Json::object()}}},
          {"printerprofiles", {{"profiles", {{"_default", profile}}}}}};
}

Json files(const std::vector<queue::Job>& jobs, std::uintmax_t free_bytes) {
  std::map<std::string, Json> latest;
  for (const queue::Job& job : jobs) {
    latest[job.name] = file_json(job.name, job.bytes, job.uploaded_ms);
  }
  Json list = Json::array();
  for (const auto& [name, file] : latest) list.push_back(file);
  return {{"files", list}, {"free", free_bytes}};
}

View view_of(const Json& snapshot, const std::string& printer) {
  const auto& printers = snapshot.at("printers");
  const auto found =
      std::ranges::find_if(printers, [&](const Json& each) { return each.at("name") == printer; });
  const Json job_id = found->at("job");
  for (const Json& job : snapshot.at("jobs")) {
    if (job.at("id") == job_id) return {*found, job};
  }
  return {*found, Json()};
}

bool View::is_operational() const { return printer_.at("link") == "ready"; }
bool View::is_printing() const { return !job_.is_null() && !is_paused(); }
bool View::is_paused() const { return !job_.is_null() && job_.at("state") == "paused"; }

std::string View::state() const {
  if (!is_operational()) return job_.is_null() ? "Offline" : "Offline (a job is under way)";
  if (printer_.at("phase") == "cancelling") return "Cancelling";
  if (is_paused()) return "Paused";
  if (job_.is_null()) return "Operational";
  return job_.at("state") == "starting" ? "Starting" : "Printing";
}

Json View::job() const {
  if (job_.is_null()) {
    return {{"job",
             {{"file", {{"name", nullptr}, {"path", nullptr}, {"origin", nullptr}}},
              {"estimatedPrintTime", nullptr},
              {"filament", nullptr}}},
            {"progress",
             {{"completion", nullptr},
              {"filepos", nullptr},
              {"printTime", nullptr},
              {"printTimeLeft", nullptr}}},
            {"state", state()}};
  }
  const double commands = job_.at("commands"), done = printer_.at("done");
  const double part = commands > 0 ? std::clamp(done / commands, 0.0, 1.0) : 0;
  const double seconds = job_.at("seconds");
  return {{"job",
           {{"file", file_json(job_.at("name"), job_.at("bytes"), job_.at("uploaded_ms"))},
            {"estimatedPrintTime", seconds},
            {"filament", {{"tool0", {{"length", job_.at("filament_mm")}}}}}}},
          {"progress",
           {{"completion", part * 100},
            {"filepos", nullptr},
            {"printTime", std::round(seconds * part)},
            {"printTimeLeft", std::round(seconds * (1 - part))}}},
          {"state", state()}};
}

Json View::printer() const {
  const bool cancelling = printer_.at("phase") == "cancelling";
  const Json flags{{"operational", true},   {"printing", is_printing() && !cancelling},
                   {"paused", is_paused()}, {"pausing", false},
                   {"resuming", false},     {"cancelling", cancelling},
                   {"finishing", false},    {"sdReady", false},
                   {"error", false},        {"ready", job_.is_null()},
                   {"closedOrError", false}};
  return {{"temperature",
           {{"tool0", heater(printer_.at("hotend"))}, {"bed", heater(printer_.at("bed"))}}},
          {"sd", {{"ready", false}}},
          {"state", {{"text", state()}, {"flags", flags}}}};
}

Json View::connection() const {
  return {{"current",
           {{"state", state()},
            {"port", printer_.at("name")},
            {"baudrate", nullptr},
            {"printerProfile", "_default"}}},
          {"options",
           {{"ports", {printer_.at("name")}},
            {"baudrates", Json::array()},
            {"printerProfiles", {{{"id", "_default"}, {"name", "StepFabric"}}}},
            {"portPreference", nullptr},
            {"baudratePreference", nullptr},
            {"printerProfilePreference", "_default"},
            {"autoconnect", true}}}};
}

}  // namespace web::octoprint
