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

queue::Job job_in(Core& core, const Json& params) {
  const std::int64_t id = integer_in(params, "uid", 0);
  const auto job = core.spooler.find(id);
  if (!job || !was_begun_on(*job, core.printer)) throw Error(404, "there is no such job");
  return *job;
}

// The latest first.
std::vector<Json> all_of(Core& core) {
  std::vector<Json> list;
  for (const queue::Job& job : core.spooler.jobs()) {
    if (was_begun_on(job, core.printer)) list.push_back(history_item(core, job));
  }
  std::ranges::stable_sort(list, std::greater{},
                           [](const Json& job) { return job.at("start_time").get<double>(); });
  return list;
}

Json list(Core& core, const Json& params, Connection*) {
  const auto start = std::max<std::int64_t>(integer_in(params, "start", 0), 0);
  const auto limit =
      std::clamp<std::int64_t>(integer_in(params, "limit", usual_limit), 0, largest_limit);
  std::vector<Json> all = all_of(core);
  if (text_in(params, "order", "desc") == "asc") std::ranges::reverse(all);
  const auto begins_in = [&](const Json& job) {
    const auto time = job.at("start_time").get<double>();
    const auto before = static_cast<double>(integer_in(params, "before", 0));
    return (before == 0 || time < before) &&
           time > static_cast<double>(integer_in(params, "since", 0));
  };
  Json found = Json::array();
  std::int64_t count = 0;
  for (const Json& job : all) {
    if (!begins_in(job)) continue;
    if (count >= start && count < start + limit) found.push_back(job);
    ++count;
  }
  return {{"count", count}, {"jobs", found}};
}

Json totals(Core& core, const Json&, Connection*) {
  double time = 0, printing = 0, filament = 0, longest = 0, longest_print = 0;
  const std::vector<Json> all = all_of(core);
  for (const Json& job : all) {
    time += job.at("total_duration").get<double>();
    printing += job.at("print_duration").get<double>();
    filament += job.at("filament_used").get<double>();
    longest = std::max(longest, job.at("total_duration").get<double>());
    longest_print = std::max(longest_print, job.at("print_duration").get<double>());
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
  const JobTimes times =
      times_of(core.spooler.history(job.id), static_cast<std::int64_t>(unix_time() * 1000));
  const auto status = [&] {
    if (queue::is_active(job.state)) return "in_progress";
    if (job.state == queue::JobState::finished) return "completed";
    if (job.state == queue::JobState::cancelled) return "cancelled";
    return job.state == queue::JobState::failed ? "error" : "interrupted";
  };
  const bool is_complete = job.state == queue::JobState::finished;
  return {{"job_id", std::to_string(job.id)},
          {"exists", true},
          {"filename", job.name},
          {"status", status()},
          {"start_time", times.started},
          {"end_time", times.ended > 0 ? Json(times.ended) : Json()},
          {"print_duration", times.printing},
          {"total_duration", times.total},
          {"filament_used", is_complete ? job.filament_mm : 0.0},
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
