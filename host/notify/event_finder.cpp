// SPDX-License-Identifier: Apache-2.0
// Compares what is with what was at the last look.
#include "host/notify/event_finder.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace notify {

namespace {

struct Row {
  std::string_view state;
  Kind kind;
};
// Of a job that was in another state before.
constexpr std::array kinds{
    Row{"paused", Kind::job_paused},       Row{"finished", Kind::job_finished},
    Row{"cancelled", Kind::job_cancelled}, Row{"failed", Kind::job_failed},
    Row{"refused", Kind::job_refused},     Row{"interrupted", Kind::job_interrupted}};

std::optional<Kind> kind_of(std::string_view state, std::string_view before) {
  if (state == before) return std::nullopt;
  if (state == "printing") {  // that of a resumed one was its pause
    return before == "paused" ? std::nullopt : std::optional(Kind::job_started);
  }
  const auto* const row = std::ranges::find(kinds, state, &Row::state);
  return row == kinds.end() ? std::nullopt : std::optional(row->kind);
}

bool is_ready(const Json& printer) { return printer.at("link") == "ready"; }

// A job for any printer may start there at once.
bool is_free(const Json& printer) {
  return is_ready(printer) && printer.at("bed_clear") && printer.at("job").is_null();
}

std::string why_lost(const Json& printer) {
  const std::string& link = printer.at("link").get_ref<const std::string&>();
  const std::string& fault = printer.at("fault").get_ref<const std::string&>();
  std::string why = link == "closed"    ? "its port cannot be opened: cable or power"
                    : link == "unknown" ? "its feeder is not heard"
                                        : "it does not answer";
  return fault.empty() ? why : why + "; " + fault;
}

}  // namespace

std::vector<Event> EventFinder::look(const Json& snapshot, Time now) {
  jobs_ = &snapshot.at("jobs");
  look_at_jobs(*jobs_);
  for (const Json& printer : snapshot.at("printers")) {
    Printer& known = printers_[printer.at("name").get<std::string>()];
    look_at_link(printer, known, now);
    look_at_user(printer, known);
    look_at_bed(snapshot, printer, known);
  }
  jobs_ = nullptr;
  if (std::exchange(is_first_, false)) events_.clear();
  return std::exchange(events_, {});
}

// A job that is over may leave the snapshot, which has the latest ones, and come back when others
// are removed: only one with a new number is new.
void EventFinder::look_at_jobs(const Json& jobs) {
  std::map<std::int64_t, std::string> states;
  std::int64_t highest = highest_;
  for (const Json& job : jobs) {
    const std::int64_t id = job.at("id");
    const std::string state = job.at("state");
    const auto old = states_.find(id);
    const bool is_known = old != states_.end();
    if (is_known || id > highest_) {
      if (const auto kind = kind_of(state, is_known ? old->second : "uploaded")) {
        const std::string& wanted = job.at("wanted_printer").get_ref<const std::string&>();
        const std::string& printer = job.at("printer").get_ref<const std::string&>();
        tell(*kind, printer.empty() ? wanted : printer, &job, job.at("reason"));
      }
    }
    states[id] = state;
    highest = std::max(highest, id);
  }
  states_ = std::move(states);
  highest_ = highest;
}

void EventFinder::look_at_link(const Json& printer, Printer& known, Time now) {
  const std::string name = printer.at("name");
  if (is_ready(printer)) {
    if (std::exchange(known.is_lost, false)) tell(Kind::printer_back, name, job_of(printer), "");
    known.was_ready = true;
    known.away_since.reset();
    return;
  }
  // One that was never there, such as one that is switched off over night, is not lost.
  const bool is_missed = known.was_ready || !printer.at("job").is_null();
  if (!is_missed) return;
  if (!known.away_since) known.away_since = now;
  if (known.is_lost || now - *known.away_since < grace_) return;
  known.is_lost = true;
  tell(Kind::printer_lost, name, job_of(printer), why_lost(printer));
}

void EventFinder::look_at_user(const Json& printer, Printer& known) {
  if (!is_ready(printer)) {
    return;  // what it says is old
  }
  const bool awaits = printer.at("waits_for_user");
  if (awaits && !known.awaits_user) {
    tell(Kind::user_awaited, printer.at("name"), job_of(printer),
         "the printer waits for a person, as at M0 or for a change of filament");
  }
  known.awaits_user = awaits;
}

void EventFinder::look_at_bed(const Json& snapshot, const Json& printer, Printer& known) {
  const bool another_is_free = std::ranges::any_of(snapshot.at("printers"), is_free);
  const bool may_wait = !printer.at("bed_clear").get<bool>() && printer.at("job").is_null();
  const auto waits_here = [&](const Json& job) {
    if (job.at("state") != "queued" || job.at("held")) return false;
    const Json& wanted = job.at("wanted_printer");
    return wanted == printer.at("name") || (wanted == "" && !another_is_free);
  };
  const auto job = may_wait ? std::ranges::find_if(*jobs_, waits_here) : jobs_->end();
  const bool awaits = job != jobs_->end();
  if (awaits && !known.awaits_bed) {
    tell(Kind::bed_to_be_cleared, printer.at("name"), &*job,
         "the job starts when a person has confirmed that the bed is clear");
  }
  known.awaits_bed = awaits;
}

const Json* EventFinder::job_of(const Json& printer) const {
  const auto job = std::ranges::find_if(
      *jobs_, [&](const Json& each) { return each.at("id") == printer.at("job"); });
  return job == jobs_->end() ? nullptr : &*job;
}

void EventFinder::tell(Kind kind, const std::string& printer, const Json* job, std::string reason) {
  Event event{.kind = kind, .printer = printer, .reason = std::move(reason)};
  if (job != nullptr) {
    event.job = job->at("id").get<std::int64_t>();
    event.file = job->at("name");
  }
  events_.push_back(std::move(event));
}

}  // namespace notify
