// SPDX-License-Identifier: Apache-2.0
// server.history: the jobs that this printer has begun.
#include <algorithm>
#include <functional>

#include "host/moonraker/files.hpp"
#include "host/moonraker/history.hpp"
#include "host/moonraker/method_tables.hpp"

namespace moonraker {

namespace {

constexpr std::int64_t usual_limit = 50, largest_limit = 1000;

JobTimes times_until_now(Core& core, const queue::Job& job) {
  return times_of(core.spooler.history(job.id), static_cast<std::int64_t>(unix_time() * 1000));
}

queue::Job job_in(Core& core, const Json& params) {
  const std::int64_t id = integer_in(params, "uid", 0);
  const auto job = core.spooler.find(id);
  if (!job || !was_begun_on(*job, core.printer)) throw Error(404, "there is no such job");
  return *job;
}

struct Begun {
  queue::Job job;
  JobTimes times;
};

// The latest first.
std::vector<Begun> all_of(Core& core) {
  std::vector<Begun> list;
  for (queue::Job& job : core.spooler.jobs()) {
    if (!was_begun_on(job, core.printer)) continue;
    const JobTimes times = times_until_now(core, job);
    list.push_back({.job = std::move(job), .times = times});
  }
  std::ranges::stable_sort(list, std::greater{},
                           [](const Begun& begun) { return begun.times.started; });
  return list;
}

Json list(Core& core, const Json& params, Connection*) {
  const auto start = std::max<std::int64_t>(integer_in(params, "start", 0), 0);
  const auto limit =
      std::clamp<std::int64_t>(integer_in(params, "limit", usual_limit), 0, largest_limit);
  const auto before = static_cast<double>(integer_in(params, "before", 0));
  const auto since = static_cast<double>(integer_in(params, "since", 0));
  std::vector<Begun> all = all_of(core);
  if (text_in(params, "order", "desc") == "asc") std::ranges::reverse(all);
  std::erase_if(all, [&](const Begun& begun) {
    const double time = begun.times.started;
    return (before != 0 && time >= before) || time <= since;
  });
  const auto count = static_cast<std::int64_t>(all.size());
  Json found = Json::array();
  for (std::int64_t i = start; i < count && i - start < limit; ++i) {
    found.push_back(history_item(core, all[static_cast<std::size_t>(i)].job));
  }
  return {{"count", count}, {"jobs", found}};
}

double filament_of(const queue::Job& job) {
  return job.state == queue::JobState::finished ? job.filament_mm : 0.0;
}

Json totals(Core& core, const Json&, Connection*) {
  double time = 0, printing = 0, filament = 0, longest = 0, longest_print = 0;
  const std::vector<Begun> all = all_of(core);
  for (const auto& [job, times] : all) {
    time += times.total;
    printing += times.printing;
    filament += filament_of(job);
    longest = std::max(longest, times.total);
    longest_print = std::max(longest_print, times.printing);
  }
  return {{"job_totals",
           {{"total_jobs", all.size()},
            {"total_time", time},
            {"total_print_time", printing},
            {"total_filament_used", filament},
            {"longest_job", longest},
            {"longest_print", longest_print}}},
          {"auxiliary_totals", Json::array()}};
}

Json one(Core& core, const Json& params, Connection*) {
  return {{"job", history_item(core, job_in(core, params))}};
}

Json remove(Core& core, const Json& params, Connection*) {
  Json removed = Json::array();
  const auto remove_one = [&](const queue::Job& job) {
    core.spooler.remove(job.id);
    removed.push_back(std::to_string(job.id));
  };
  if (!flag_in(params, "all")) {
    remove_one(job_in(core, params));
    return {{"deleted_jobs", removed}};
  }
  for (const queue::Job& job : core.spooler.jobs()) {
    if (was_begun_on(job, core.printer) && queue::is_final(job.state)) remove_one(job);
  }
  return {{"deleted_jobs", removed}};
}

}  // namespace

bool was_begun_on(const queue::Job& job, const std::string& printer) {
  return job.printer == printer && job.starts > 0;
}

Json history_item(Core& core, const queue::Job& job) {
  const JobTimes times = times_until_now(core, job);
  const auto status = [&] {
    if (queue::is_active(job.state)) return "in_progress";
    if (job.state == queue::JobState::finished) return "completed";
    if (job.state == queue::JobState::cancelled) return "cancelled";
    return job.state == queue::JobState::failed ? "error" : "interrupted";
  };
  return {{"job_id", std::to_string(job.id)},
          {"exists", true},
          {"filename", job.name},
          {"status", status()},
          {"start_time", times.started},
          {"end_time", times.ended > 0 ? Json(times.ended) : Json()},
          {"print_duration", times.printing},
          {"total_duration", times.total},
          {"filament_used", filament_of(job)},
          {"metadata", metadata(core, job)},
          {"auxiliary_data", Json::array()}};
}

std::vector<Method> history_methods() {
  return {{"server.history.list", "GET", "/server/history/list", list},
          {"server.history.totals", "GET", "/server/history/totals", totals},
          {"server.history.get_job", "GET", "/server/history/job", one},
          {"server.history.delete_job", "DELETE", "/server/history/job", remove}};
}

}  // namespace moonraker
