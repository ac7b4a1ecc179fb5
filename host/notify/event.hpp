// SPDX-License-Identifier: Apache-2.0
// What a person wants to hear of without looking.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace notify {

using Json = nlohmann::json;

enum class Kind : std::uint8_t {
  job_started,
  job_paused,  // by a person, or by the printer or a line of the file
  job_finished,
  job_cancelled,
  job_failed,
  job_refused,  // its check found lines that the firmware refuses
  job_interrupted,  // a person decides whether it is printed again
  bed_to_be_cleared,  // a job waits for nothing else
  user_awaited,  // the printer waits at its buttons: M0, a change of filament
  printer_lost,  // no answer for some seconds
  printer_back,
};

std::string_view name_of(Kind kind);

struct Event {
  Kind kind{};
  std::string printer{};  // empty where the job has none yet
  std::optional<std::int64_t> job{};
  std::string file{};  // the job's name, for people
  std::string reason{};  // for people, or empty
  std::int64_t time_ms{};  // since 1970
  std::string id{};  // of this one alone: who gets it twice knows it by that
};

// {"id", "event", "printer", "job", "file", "reason", "time"}: `time` as RFC 3339 has it, in UTC;
// `printer` and `job` are null where there is none.
Json to_json(const Event& event);
// UTF-8 whatever names and reasons hold.
std::string text_of(const Json& json);

}  // namespace notify
