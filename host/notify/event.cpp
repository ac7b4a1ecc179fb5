// SPDX-License-Identifier: Apache-2.0
// Names and JSON of events.
#include "host/notify/event.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>

namespace notify {

namespace {

std::string written_time(std::int64_t time_ms) {
  const auto seconds = static_cast<std::time_t>(time_ms / 1000);
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", parts, time_ms % 1000);
}

}  // namespace

std::string_view name_of(Kind kind) {
  switch (kind) {
    case Kind::job_started:
      return "job_started";
    case Kind::job_paused:
      return "job_paused";
    case Kind::job_finished:
      return "job_finished";
    case Kind::job_cancelled:
      return "job_cancelled";
    case Kind::job_failed:
      return "job_failed";
    case Kind::job_refused:
      return "job_refused";
    case Kind::job_interrupted:
      return "job_interrupted";
    case Kind::bed_to_be_cleared:
      return "bed_to_be_cleared";
    case Kind::user_awaited:
      return "user_awaited";
    case Kind::printer_lost:
      return "printer_lost";
    case Kind::printer_back:
      return "printer_back";
  }
  return "";
}

Json to_json(const Event& event) {
  return {{"id", event.id},
          {"event", name_of(event.kind)},
          {"printer", event.printer.empty() ? Json() : Json(event.printer)},
          {"job", event.job ? Json(*event.job) : Json()},
          {"file", event.file},
          {"reason", event.reason},
          {"time", written_time(event.time_ms)}};
}

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace notify
