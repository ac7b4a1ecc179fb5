// SPDX-License-Identifier: Apache-2.0
// A job as the queue holds it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "host/queue/job_state.hpp"

namespace queue {

using JobId = std::int64_t;  // never used twice

struct Job {
  JobId id{};
  std::string name;  // for people, cleaned
  std::string file;  // its name in the store
  std::int64_t bytes{};
  JobState state{JobState::uploaded};
  bool held = false;  // waits for a person's release before it may start
  std::string wanted_printer;  // empty: any
  std::string printer;  // that has it, or had it last; empty: none yet
  std::string reason;  // of the last change of state, for people
  std::string check;  // result of the check, JSON; empty: not checked yet
  double seconds{};  // planned, without heating; 0: not known
  double filament_mm{};  // planned
  std::int64_t commands{};  // that are sent; 0: not known yet
  std::int64_t starts{};  // how often it went to a printer
  std::int64_t uploaded_ms{};  // since 1970, as all times
  std::int64_t changed_ms{};
  bool operator==(const Job&) const = default;
};

// "job 3 is queued" and the rest.
std::string sentence(const Job& job, std::string_view rest);

// A change of state that was committed.
struct Change {
  JobId job{};
  JobState from{};
  JobState to{};
  std::string why;
  std::int64_t time_ms{};
};

}  // namespace queue
