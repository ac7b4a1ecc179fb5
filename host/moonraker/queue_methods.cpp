// SPDX-License-Identifier: Apache-2.0
// server.job_queue: the spooler's queue. It runs by itself; what holds it back is a bed that is not
// clear, which only a person can know.
#include <algorithm>
#include <charconv>

#include "host/moonraker/files.hpp"
#include "host/moonraker/job_list.hpp"
#include "host/moonraker/method_tables.hpp"
#include "host/moonraker/script.hpp"

namespace moonraker {

namespace {

bool waits(const queue::Job& job, const std::string& printer) {
  const bool is_ours = job.wanted_printer.empty() || job.wanted_printer == printer;
  return is_ours && !job.held && !queue::is_final(job.state) && !queue::is_active(job.state) &&
         job.state != queue::JobState::interrupted;
}

Json status(Core& core, const Json&, Connection*) {
  JobList list = job_list(core);
  return {{"queued_jobs", std::move(list.jobs)}, {"queue_state", list.state}};
}

// A list, or names with commas between them.
std::vector<std::string> names_in(const Json& params, const char* name) {
  const auto found = params.find(name);
  std::vector<std::string> names;
  if (found == params.end()) throw Error(invalid_params, std::string("`") + name + "` is missing");
  if (found->is_array()) return found->get<std::vector<std::string>>();
  const std::string text = text_in(params, name);
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    names.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return names;
}

Json add(Core& core, const Json& params, Connection* connection) {
  const auto names = names_in(params, "filenames");
  for (const std::string& name : names) {
    file_named(core, name);  // all of them, or none
  }
  for (const std::string& name : names) print_file(core, name);
  return status(core, params, connection);
}

queue::JobId number_of(const std::string& text) {
  queue::JobId id = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id);
  if (error != std::errc{} || end != text.data() + text.size()) throw queue::NoSuchJob(0);
  return id;
}

Json remove(Core& core, const Json& params, Connection* connection) {
  if (flag_in(params, "all")) {
    for (const queue::Job& job : core.spooler.jobs()) {
      if (waits(job, core.printer)) core.spooler.cancel(job.id);
    }
    return status(core, params, connection);
  }
  for (const std::string& text : names_in(params, "job_ids")) {
    const queue::JobId id = number_of(text);
    const auto job = core.spooler.find(id);
    if (!job || !waits(*job, core.printer)) throw queue::NoSuchJob(id);
    core.spooler.cancel(id);
  }
  return status(core, params, connection);
}

Json jump(Core& core, const Json& params, Connection* connection) {
  const queue::JobId id = number_of(text_in(params, "job_id"));
  for (const queue::Job& job : core.spooler.jobs()) {
    if (!waits(job, core.printer)) continue;
    if (job.id != id) core.spooler.move(id, job.id);
    break;
  }
  return status(core, params, connection);
}

Json pause(Core& core, const Json& params, Connection* connection) {
  core.spooler.set_bed_clear(core.printer, false);
  return status(core, params, connection);
}

Json start(Core& core, const Json& params, Connection* connection) {
  if (!core.view().bed_is_clear()) {
    throw Error(400, "the queue goes on when the bed is clear: confirm it by BED_CLEAR");
  }
  return status(core, params, connection);
}

}  // namespace

JobList job_list(Core& core) {
  JobList list{.state = core.view().bed_is_clear() ? "ready" : "paused"};
  const double now = unix_time();
  for (const queue::Job& job : core.spooler.jobs()) {
    if (!waits(job, core.printer)) continue;
    const double added = static_cast<double>(job.uploaded_ms) / 1000;
    list.jobs.push_back({{"filename", job.name},
                         {"job_id", std::to_string(job.id)},
                         {"time_added", added},
                         {"time_in_queue", now - added}});
  }
  return list;
}

std::vector<Method> queue_methods() {
  return {{"server.job_queue.status", "GET", "/server/job_queue/status", status},
          {"server.job_queue.post_job", "POST", "/server/job_queue/job", add},
          {"server.job_queue.delete_job", "DELETE", "/server/job_queue/job", remove},
          {"server.job_queue.pause", "POST", "/server/job_queue/pause", pause},
          {"server.job_queue.start", "POST", "/server/job_queue/start", start},
          {"server.job_queue.jump", "POST", "/server/job_queue/jump", jump}};
}

}  // namespace moonraker
