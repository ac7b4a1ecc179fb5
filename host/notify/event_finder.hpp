// SPDX-License-Identifier: Apache-2.0
// Events out of the spooler's snapshots. Pure logic: time comes in.
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/notify/event.hpp"

namespace notify {

using Time = std::chrono::milliseconds;  // from any origin

// What is there at the first look is no news. States that come and go between two looks are not
// seen, but for the last one of each job.
class EventFinder {
 public:
  // `grace`: so long a printer may be silent or unplugged before it counts as lost; a feeder that
  // is started again is back sooner.
  explicit EventFinder(Time grace = Time{10'000}) : grace_(grace) {}

  // To be called again and again, also with the same snapshot. The events have no id and no time.
  std::vector<Event> look(const Json& snapshot, Time now);

 private:
  struct Printer {
    bool was_ready = false, is_lost = false, awaits_bed = false, awaits_user = false;
    std::optional<Time> away_since;
  };

  void look_at_jobs(const Json& jobs);
  void look_at_link(const Json& printer, Printer& known, Time now);
  void look_at_user(const Json& printer, Printer& known);
  void look_at_bed(const Json& snapshot, const Json& printer, Printer& known);
  void tell(Kind kind, const std::string& printer, const Json* job, std::string reason);
  const Json* job_of(const Json& printer) const;

  const Time grace_;
  bool is_first_ = true;
  const Json* jobs_ = nullptr;  // of this look
  std::vector<Event> events_;  // of this look
  std::map<std::int64_t, std::string> states_;  // of the jobs of the last snapshot
  std::int64_t highest_ = 0;  // number of a job that was seen
  std::map<std::string, Printer> printers_;
};

}  // namespace notify
