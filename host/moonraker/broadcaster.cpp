// SPDX-License-Identifier: Apache-2.0
// Each pass compares what is with what was reported last.
#include "host/moonraker/broadcaster.hpp"

#include <algorithm>
#include <chrono>

#include "host/moonraker/files.hpp"
#include "host/moonraker/history.hpp"
#include "host/moonraker/job_list.hpp"
#include "host/moonraker/rpc.hpp"

namespace moonraker {

namespace {

using namespace std::chrono_literals;
constexpr auto shortest_interval = 250ms;  // as Moonraker's

}  // namespace

// What is there now is no news; what comes after the constructor is.
Broadcaster::Broadcaster(Core& core) : core_(core) {
  try_pass();
  thread_ = std::thread([this] { run(); });
}

Broadcaster::~Broadcaster() {
  {
    const std::scoped_lock lock(mutex_);
    ends_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void Broadcaster::run() {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, shortest_interval, [this] { return ends_; })) {
    lock.unlock();
    try_pass();
    lock.lock();
  }
}

void Broadcaster::try_pass() {
  try {
    pass();
  } catch (const std::exception&) {  // the queue cannot be read now: the next pass reports it
  }
}

void Broadcaster::pass() {
  const PrinterView view = core_.view();
  const Json objects = view.objects();
  tell_klippy_state(view);
  tell_console(view);
  const std::int64_t version = core_.spooler.snapshot()->version;
  if (version != version_) tell_jobs();
  version_ = version;
  core_.hub.update(objects, event_time());
  const double now = event_time();
  if (now - sampled_at_ >= 1) {
    sampled_at_ = now;
    core_.temperatures.sample(objects);
    tell("notify_proc_stat_update", Json::array({process_stats(used_, core_.hub.size())}));
  }
  is_first_ = false;
}

void Broadcaster::tell(std::string_view method, const Json& params) {
  if (!is_first_) core_.hub.broadcast(notification(method, params));
}

void Broadcaster::tell_klippy_state(const PrinterView& view) {
  const std::string state(view.klippy_state());
  if (state == klippy_state_) return;
  klippy_state_ = state;
  if (state == "ready") tell("notify_klippy_ready");
  if (state == "disconnected" || state == "startup") tell("notify_klippy_disconnected");
  if (state == "shutdown") tell("notify_klippy_shutdown");
}

void Broadcaster::tell_console(const PrinterView& view) {
  for (const Json& line : view.printer().at("console")) {
    const std::int64_t number = line.at("number");
    if (number <= said_) continue;
    said_ = number;
    const std::string text = line.at("text");
    if (!text.starts_with("> ")) tell("notify_gcode_response", Json::array({text}));
  }
}

void Broadcaster::tell_jobs() {
  tell_files();
  tell_queue();
  tell_history();
}

void Broadcaster::tell_files() {
  std::map<std::string, File> files;
  for (const auto& [name, job] : files_of(core_)) {
    files[name] = {.stored = job.file, .bytes = job.bytes, .uploaded_ms = job.uploaded_ms};
  }
  const auto say = [&](const char* action, const std::string& name, const File& file) {
    tell("notify_filelist_changed",
         Json::array(
             {{{"action", action}, {"item", changed_item(name, file.bytes, file.uploaded_ms)}}}));
  };
  for (const auto& [name, file] : files_) {
    if (!files.contains(name)) say("delete_file", name, file);
  }
  for (const auto& [name, file] : files) {
    const auto old = files_.find(name);
    if (old == files_.end()) {
      say("create_file", name, file);
    } else if (old->second.stored != file.stored) {
      say("modify_file", name, file);
    }
  }
  files_ = std::move(files);
}

void Broadcaster::tell_queue() {
  const JobList list = job_list(core_);
  std::vector<std::string> numbers;
  for (const Json& job : list.jobs) numbers.push_back(job.at("job_id").get<std::string>());
  const bool is_same = numbers == queued_;
  if (is_same && list.state == queue_state_) return;
  const bool has_new = std::ranges::any_of(
      numbers, [&](const std::string& id) { return !std::ranges::contains(queued_, id); });
  const char* action = is_same ? "state_changed" : has_new ? "jobs_added" : "jobs_removed";
  tell("notify_job_queue_changed", Json::array({{{"action", action},
                                                 {"updated_queue", is_same ? Json() : list.jobs},
                                                 {"queue_state", list.state}}}));
  queued_ = std::move(numbers);
  queue_state_ = list.state;
}

void Broadcaster::tell_history() {
  std::map<queue::JobId, bool> begun;
  for (const queue::Job& job : core_.spooler.jobs()) {
    if (!was_begun_on(job, core_.printer)) continue;
    const bool is_over = !queue::is_active(job.state);
    const auto old = begun_.find(job.id);
    begun[job.id] = is_over;
    if (is_first_ || (old != begun_.end() && old->second == is_over)) continue;
    tell("notify_history_changed", Json::array({{{"action", is_over ? "finished" : "added"},
                                                 {"job", history_item(core_, job)}}}));
  }
  begun_ = std::move(begun);
}

}  // namespace moonraker
