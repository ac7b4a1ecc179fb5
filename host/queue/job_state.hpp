// SPDX-License-Identifier: Apache-2.0
// The states of a job, and the one table of the permitted changes between them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace queue {

enum class JobState : std::uint8_t {
  uploaded,  // the file is on the disk and the job is committed
  checking,  // the whole file runs through the firmware's planner
  refused,  // the check found lines that the firmware refuses: never printed
  queued,  // waits for a printer with a free bed
  starting,  // committed before the first byte leaves for the printer
  printing,
  paused,
  finished,
  cancelled,  // by a person
  failed,  // the printer reported an error, or was stopped
  interrupted,  // how far it was printed is not known: a person decides
};

inline constexpr std::array job_states{
    JobState::uploaded,  JobState::checking, JobState::refused,    JobState::queued,
    JobState::starting,  JobState::printing, JobState::paused,     JobState::finished,
    JobState::cancelled, JobState::failed,   JobState::interrupted};

struct Transition {
  JobState from;
  JobState to;
  std::string_view why;
};

inline constexpr std::array transitions{
    Transition{JobState::uploaded, JobState::checking, "its check begins"},
    Transition{JobState::uploaded, JobState::cancelled, "by a person"},
    Transition{JobState::checking, JobState::uploaded, "the check did not end: again"},
    Transition{JobState::checking, JobState::refused, "lines are refused"},
    Transition{JobState::checking, JobState::queued, "every line is taken"},
    Transition{JobState::checking, JobState::cancelled, "by a person"},
    Transition{JobState::queued, JobState::starting, "a printer with a free bed is ready"},
    Transition{JobState::queued, JobState::cancelled, "by a person"},
    Transition{JobState::starting, JobState::queued, "the feeder knows it did not begin"},
    Transition{JobState::starting, JobState::printing, "the feeder has begun"},
    Transition{JobState::starting, JobState::interrupted, "it is not known whether it began"},
    Transition{JobState::printing, JobState::paused, "by a person or the printer"},
    Transition{JobState::printing, JobState::finished, "the printer has executed every line"},
    Transition{JobState::printing, JobState::cancelled, "by a person"},
    Transition{JobState::printing, JobState::failed, "by an error of the printer"},
    Transition{JobState::printing, JobState::interrupted, "the printer was restarted"},
    Transition{JobState::paused, JobState::printing, "resumed"},
    Transition{JobState::paused, JobState::cancelled, "by a person"},
    Transition{JobState::paused, JobState::failed, "by an error of the printer"},
    Transition{JobState::paused, JobState::interrupted, "the printer was restarted"},
    Transition{JobState::interrupted, JobState::queued, "a person wants it printed again"},
    Transition{JobState::interrupted, JobState::cancelled, "a person gives it up"},
};

constexpr bool is_permitted(JobState from, JobState to) {
  for (const Transition& row : transitions) {
    if (row.from == from && row.to == to) return true;
  }
  return false;
}

// Nothing leads out of it.
constexpr bool is_final(JobState state) {
  for (const Transition& row : transitions) {
    if (row.from == state) return false;
  }
  return true;
}

// It has a printer, and no other job may have the same one.
constexpr bool is_active(JobState state) {
  return state == JobState::starting || state == JobState::printing || state == JobState::paused;
}

// As the database and the API have it.
constexpr std::string_view name_of(JobState state) {
  switch (state) {
    case JobState::uploaded:
      return "uploaded";
    case JobState::checking:
      return "checking";
    case JobState::refused:
      return "refused";
    case JobState::queued:
      return "queued";
    case JobState::starting:
      return "starting";
    case JobState::printing:
      return "printing";
    case JobState::paused:
      return "paused";
    case JobState::finished:
      return "finished";
    case JobState::cancelled:
      return "cancelled";
    case JobState::failed:
      return "failed";
    case JobState::interrupted:
      return "interrupted";
  }
  return "";
}

constexpr std::optional<JobState> state_named(std::string_view name) {
  for (const JobState state : job_states) {
    if (name_of(state) == name) return state;
  }
  return std::nullopt;
}

// What must hold whatever rows are added.
static_assert(is_final(JobState::refused), "a refused job is never printed");
static_assert(is_final(JobState::finished) && is_final(JobState::failed) &&
              is_final(JobState::cancelled));
static_assert(
    [] {
      for (const Transition& row : transitions) {
        if (row.to == JobState::printing && row.from != JobState::starting &&
            row.from != JobState::paused) {
          return false;
        }
        if (row.to == JobState::starting && row.from != JobState::queued) return false;
      }
      return true;
    }(),
    "nothing prints that was not committed as starting, and only a checked job starts");

}  // namespace queue
