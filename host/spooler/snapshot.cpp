// SPDX-License-Identifier: Apache-2.0
// The state of everything, for people and programs.
#include "host/spooler/snapshot.hpp"

#include <algorithm>

#include "host/queue/now.hpp"
#include "host/spooler/spooler.hpp"

namespace spooler {

using Json = nlohmann::json;

namespace {

constexpr std::int64_t most_jobs_over = 50;
constexpr std::size_t most_console_lines = 60;

Json number(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

}  // namespace

Json to_json(const queue::Job& job) {
  return {{"id", job.id},
          {"name", job.name},
          {"bytes", job.bytes},
          {"state", name_of(job.state)},
          {"held", job.held},
          {"wanted_printer", job.wanted_printer},
          {"printer", job.printer},
          {"reason", job.reason},
          {"seconds", job.seconds},
          {"filament_mm", job.filament_mm},
          {"commands", job.commands},
          {"starts", job.starts},
          {"uploaded_ms", job.uploaded_ms},
          {"changed_ms", job.changed_ms}};
}

Json Spooler::to_json(const FeederLink& printer) {
  const FeederState& state = printer.last_state();
  const auto job = std::ranges::find_if(view_.jobs, [&](const queue::Job& each) {
    return is_active(each.state) && each.printer == printer.name() && queue_.holds(printer.name());
  });
  const auto left = view_.filaments.find(printer.name());
  const auto refusal = lease_refusals_.find(printer.name());
  const std::string no_lease = refusal == lease_refusals_.end() ? "" : refusal->second;
  Json console = Json::array();
  const auto& lines = printer.console();
  const std::size_t begin =
      lines.size() > most_console_lines ? lines.size() - most_console_lines : 0;
  for (std::size_t i = begin; i < lines.size(); ++i) {
    console.push_back(
        {{"number", lines[i].number}, {"text", lines[i].text}, {"time_ms", lines[i].time_ms}});
  }
  return {
      {"name", printer.name()},
      {"simulated", printer.is_simulated()},
      {"feeder", printer.is_heard()},
      {"link", printer.is_heard() ? state.link : "unknown"},
      {"fault", !no_lease.empty()    ? no_lease
                : printer.is_heard() ? state.fault
                                     : ""},
      {"phase", state.phase},
      {"job", job != view_.jobs.end() ? Json(job->id) : Json()},
      {"feeder_job", state.job ? Json(*state.job) : Json()},
      {"done", state.done},
      {"commands", state.commands},
      {"resends", state.resends},
      {"waits_for_user", state.waits_for_user},
      {"hotend_to_restore", state.hotend_to_restore},
      {"homed", state.homed},
      {"hotend", {number(state.hotend), number(state.hotend_target), number(state.hotend_power)}},
      {"bed", {number(state.bed), number(state.bed_target), number(state.bed_power)}},
      {"position", state.position},
      {"answered_ms", printer.temperatures().heard_ms()},
      {"bed_clear", view_.clear_beds.contains(printer.name())},
      {"filament_mm", left != view_.filaments.end() ? Json(left->second) : Json()},
      {"console", console}};
}

// Printers of other spoolers.
Json Spooler::others_to_json() const {
  Json others = Json::array();
  for (const queue::Lease& lease : view_.leases) {
    if (lease.is_mine) continue;
    others.push_back({{"name", lease.printer},
                      {"place", lease.place},
                      {"lease", lease.is_over ? "ended" : "held"}});
  }
  return others;
}

Spooler::View Spooler::read_view() {
  View view{.jobs = queue_.overview(most_jobs_over),
            .clear_beds = queue_.clear_beds(),
            .filaments = queue_.filaments_left(),
            .leases = queue_.leases()};
  viewed_ms_ = queue::now_ms();
  return view;
}

std::shared_ptr<const Spooler::Snapshot> Spooler::snapshot() {
  const std::scoped_lock lock(mutex_);
  if (snapshot_) return snapshot_;
  try {
    view_ = read_view();
  } catch (const queue::Unavailable& error) {  // what was seen last, as such
    view_.is_old = true;
    fault_ = error.what();
  }
  Json json{{"version", version_},
            {"now_ms", queue::now_ms()},
            {"fault", !fault_.empty()           ? fault_
                      : !failed_checks_.empty() ? failed_checks_.begin()->second.fault
                                                : notice_},
            {"printers", Json::array()},
            {"other_printers", others_to_json()},
            {"queue_is_old", view_.is_old},
            {"queue_ms", viewed_ms_},
            {"jobs", Json::array()}};
  for (const auto& printer : printers_) json["printers"].push_back(to_json(*printer));
  for (const queue::Job& job : view_.jobs) {
    Json each = spooler::to_json(job);
    std::filesystem::path file = commands_of(job);
    each["has_path"] = std::filesystem::exists(file.replace_extension(path_ending));
    each["has_picture"] = std::filesystem::exists(file.replace_extension(picture_ending));
    json["jobs"].push_back(std::move(each));
  }
  const auto snapshot = std::make_shared<Snapshot>();
  snapshot->version = version_;
  snapshot->text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  snapshot->json = std::move(json);
  snapshot_ = snapshot;
  return snapshot_;
}

std::shared_ptr<const Spooler::Snapshot> Spooler::next_snapshot(std::int64_t version,
                                                                std::chrono::milliseconds time) {
  {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, time, [&] { return version_ != version; });
  }
  return snapshot();
}

}  // namespace spooler
