// SPDX-License-Identifier: Apache-2.0
// One printer of the spooler, as Klipper's printer objects.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/spooler/spooler.hpp"

namespace moonraker {

using Json = nlohmann::json;

// How long a job has been under way, in seconds.
struct JobTimes {
  double started = 0;  // since 1970; 0: not yet
  double ended = 0;
  double total = 0;  // since its start
  double printing = 0;  // without its pauses
};
// `now_ms`: since 1970, for a job that is not over.
JobTimes times_of(const std::vector<queue::Change>& history, std::int64_t now_ms);

class PrinterView {
 public:
  // `job`: what is printed, or was printed last; `waiting`: what comes next. Both may be null.
  PrinterView(Json printer, Json job, Json waiting, JobTimes times)
      : printer_(std::move(printer)),
        job_(std::move(job)),
        waiting_(std::move(waiting)),
        times_(times) {}

  // disconnected, startup, ready or shutdown, and a sentence about it.
  std::string_view klippy_state() const;
  std::string klippy_message() const;
  // Of print_stats: standby, printing, paused, complete, cancelled, error.
  std::string_view print_state() const;
  // What a person should know or do; or empty.
  std::string message() const;

  // All objects, by name. A field whose value is not known is left out.
  Json objects() const;

  bool has_active_job() const { return is_active_; }
  bool bed_is_clear() const { return printer_.at("bed_clear"); }
  const Json& printer() const { return printer_; }
  const Json& job() const { return job_; }
  const Json& waiting() const { return waiting_; }

 private:
  bool was_stopped() const;
  double progress() const;
  Json print_stats() const;
  Json virtual_sdcard() const;
  Json motion() const;

  Json printer_, job_, waiting_;
  JobTimes times_;
  bool is_active_ = !printer_.at("job").is_null();
};

PrinterView view_of(spooler::Spooler& spooler, const std::string& printer);

}  // namespace moonraker
