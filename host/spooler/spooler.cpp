// SPDX-License-Identifier: Apache-2.0
// The loop: files are checked, printers are followed, jobs are started.
#include "host/spooler/spooler.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <thread>
#include <utility>

namespace spooler {

using queue::Job;
using queue::JobState;

namespace {

constexpr std::chrono::milliseconds pass_interval{20}, pass_interval_after_fault{1000};
// Where a feeder refuses a job, it is not asked again at once.
constexpr std::chrono::seconds block_time{10};
constexpr int most_check_attempts = 10;  // that could not be done, in a row

std::filesystem::path made(const std::filesystem::path& folder) {
  queue::make_folder(folder);
  std::filesystem::permissions(folder, std::filesystem::perms::owner_all);
  return folder;
}

// The state of a job whose feeder is in this phase; nothing where it stays.
std::optional<JobState> state_for(const std::string& phase) {
  if (phase == "running") return JobState::printing;
  if (phase == "paused") return JobState::paused;
  if (phase == "finished") return JobState::finished;
  if (phase == "cancelled") return JobState::cancelled;
  if (phase == "failed") return JobState::failed;
  if (phase == "interrupted") return JobState::interrupted;
  return std::nullopt;  // opening, cancelling
}

}  // namespace

Spooler::FolderLock::FolderLock(const std::filesystem::path& folder)
    : file_(open((made(folder) / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {
  if (file_ < 0) throw std::runtime_error("cannot write to " + folder.string());
  if (flock(file_, LOCK_EX | LOCK_NB) == 0) return;
  close(file_);
  throw std::runtime_error("another spooler has " + folder.string());
}

Spooler::FolderLock::~FolderLock() { close(file_); }

Spooler::Spooler(Settings settings)
    : settings_(std::move(settings)),
      lock_(settings_.data),
      store_(settings_.data / "files"),
      queue_(queue_of(settings_)),
      checker_(settings_.tool_program, publish_of(settings_)) {
  for (const PrinterSpec& printer : settings_.printers) {
    printers_.push_back(std::make_unique<FeederLink>(settings_, printer));
  }
  recover();
  keep_leases();
  view_ = read_view();
}

Spooler::~Spooler() = default;

// What the last spooler left in the middle. Active jobs are followed when their feeders are heard.
void Spooler::recover() {
  if (!queue_.is_shared()) keep_files_of_a_lost_queue();
  store_.remove_all_but(queue_.files_in_use());
  const std::set<queue::JobId> own = queue_.checks();
  for (const Job& job : queue_.overview(0)) {
    if (job.state == JobState::checking && (!queue_.is_shared() || own.contains(job.id))) {
      queue_.change(job.id, JobState::uploaded, "the spooler ended during the check");
    }
  }
}

// Without queue.db nothing says which files are of jobs; one may be printed at this moment.
void Spooler::keep_files_of_a_lost_queue() {
  if (queue_.has_had_jobs()) return;
  std::vector<std::string> files = store_.files();
  if (files.empty()) return;
  for (std::string& file : files) file = file.substr(0, file.find('.')) + ".gcode";
  queue_.keep_files(files);
  notice_ = "queue.db was missing and is new: the files in " + (settings_.data / "files").string() +
            " have no job and are kept";
}

void Spooler::run(const std::function<bool()>& ended) {
  while (!ended()) {
    const bool good = pass();
    std::this_thread::sleep_for(good ? pass_interval : pass_interval_after_fault);
  }
  const std::scoped_lock lock(mutex_);
  for (const auto& printer : printers_) printer->end_if_idle();
  release_leases();
  changed();
}

// False where something failed, such as a write to a full disk: it is shown, and tried again.
bool Spooler::pass() {
  const std::scoped_lock lock(mutex_);
  std::string fault;
  bool good = true;
  const auto attempt = [&](const std::function<bool()>& step) {
    try {
      if (step()) changed();
    } catch (const queue::Unavailable& error) {  // the next attempt waits by itself
      fault = error.what();
      if (!std::exchange(view_.is_old, true)) changed();
    } catch (const std::exception& error) {
      fault = error.what();
      good = false;
    }
  };
  // The fault of one does not stop the others.
  for (const auto& printer : printers_) attempt([&] { return printer->update(); });
  attempt([this] { return keep_leases(); });
  if (is_time_to_look()) {
    attempt([this] { return end_fetch(); });
    attempt([this] { return check_files(); });
    for (const auto& printer : printers_) attempt([&] { return follow(*printer); });
    attempt([this] { return look_at_others(); });
  }
  if (fault != fault_) {
    fault_ = fault;
    changed();
  }
  return good;
}

void Spooler::note_check(const CheckResult& result) {
  const auto job = queue_.find(checker_.job());
  // It may have been cancelled, and removed.
  if (!job || job->state != JobState::checking) {
    remove_made_with(checker_.commands_file());
    return;
  }
  if (result.must_be_repeated) {
    FailedCheck& failed = failed_checks_[job->id];
    if (++failed.attempts < most_check_attempts) {
      failed.fault = job->name + ": " + result.reason + "; it is tried again";
      failed.again_at = std::chrono::steady_clock::now() + settings_.check_interval;
      queue_.change(job->id, JobState::uploaded, result.reason);
      return;
    }
  }
  queue_.set_check(job->id, result.report, result.seconds, result.filament_mm, result.commands);
  queue_.change(job->id, result.accepted ? JobState::queued : JobState::refused, result.reason);
  failed_checks_.erase(job->id);
}

// Of jobs that are not to be checked any more. True where there was one.
bool Spooler::forget_failed_checks() {
  return std::erase_if(failed_checks_, [this](const auto& each) {
           const auto job = queue_.find(each.first);
           return !job || (job->state != JobState::uploaded && job->state != JobState::checking);
         }) > 0;
}

bool Spooler::check_files() {
  bool is_changed = forget_failed_checks();
  if (const auto result = checker_.take_result()) {
    note_check(*result);
    is_changed = true;
  }
  if (!checker_.is_idle()) return is_changed;
  const std::set<queue::JobId> own = queue_.checks();
  for (const Job& job : queue_.overview(0)) {
    if (queue_.is_shared() && !own.contains(job.id)) continue;
    if (job.state == JobState::checking) {  // its result could not be written
      queue_.change(job.id, JobState::uploaded, "the check did not end");
      return true;
    }
    if (job.state != JobState::uploaded) continue;
    const auto failed = failed_checks_.find(job.id);
    const bool waits = failed != failed_checks_.end() &&
                       std::chrono::steady_clock::now() < failed->second.again_at;
    if (waits) {
      continue;  // the others do not
    }
    if (!has_files({store_.path_of(job.file)}, job)) continue;
    queue_.change(job.id, JobState::checking, "");
    checker_.begin(job.id, store_.path_of(job.file), commands_of(job));
    return true;
  }
  return is_changed;
}

// True where a job has changed.
bool Spooler::follow(FeederLink& printer) {
  const auto state = printer.state();
  if (!state || printer.is_asked() || !queue_.holds(printer.name())) return false;
  if (const auto job = queue_.active_on(printer.name())) return follow_job(printer, *job, *state);
  if (state->job) {
    // Its outcome is committed, or it is none of this queue: then a person cancels it.
    if (is_over(*state)) printer.ask({{"do", "forget"}, {"job", *state->job}}, {});
    return false;
  }
  if (end_clear_bed(printer.name())) return true;
  if (state->link == "ready") start_next(printer);
  return false;
}

void Spooler::start_next(FeederLink& printer) {
  const auto blocked = blocked_until_.find(printer.name());
  if (blocked != blocked_until_.end() && std::chrono::steady_clock::now() < blocked->second) return;
  if (!queue_.bed_is_clear(printer.name())) return;
  const auto job = queue_.next_for(printer.name());
  if (!job || !queue_.has_filament_for(*job, printer.name())) return;
  if (!has_files({commands_of(*job)}, *job)) return;
  if (!queue_.start_if_next(job->id, printer.name())) return;
  changed();
  send_start(printer, *job);
}

void Spooler::send_start(FeederLink& printer, const Job& job) {
  // Where this process stands still meanwhile, another spooler may have the printer by then.
  printer.ask({{"do", "start"},
               {"job", job.id},
               {"file", commands_of(job).string()},
               {"commands", job.commands},
               {"not_after_ms", queue_.held_until(printer.name())}},
              [this, id = job.id, name = printer.name()](const std::string& refusal) {
                if (refusal.empty() || refusal == FeederLink::connection_lost) return;
                blocked_until_[name] = std::chrono::steady_clock::now() + block_time;
                queue_.take_back(id, refusal);
                changed();
              });
}

bool Spooler::follow_job(FeederLink& printer, const Job& job, const FeederState& state) {
  if (state.job != job.id) {
    if (state.job) {  // another one, which is over or a person must end
      if (!is_over(state)) return false;
      // Its journal was damaged: whether this job had begun is not known.
      const bool lost = state.job == 0 && state.phase == "interrupted";
      if (lost) queue_.change(job.id, JobState::interrupted, state.why);
      printer.ask({{"do", "forget"}, {"job", *state.job}}, {});
      return lost;
    }
    if (job.state == JobState::starting) {
      // The journal does not have it, so not a byte of it has left.
      if (!queue_.bed_is_taken(printer.name())) {
        queue_.take_back(job.id, "the bed is not clear any more");
        return true;
      }
      if (state.link == "ready") send_start(printer, job);
      return false;
    }
    queue_.change(job.id, JobState::interrupted, "the feeder does not know the job any more",
                  filament_used(job, {}));
    return true;
  }
  Progress& progress = progress_[printer.name()];
  if (progress.job != job.id) progress = {.job = job.id, .done = 0};
  progress.done = std::max(progress.done, state.done);
  const auto wanted = state_for(state.phase);
  if (!wanted || wanted == job.state) return false;
  // What happened between two looks is written down too.
  if (!is_permitted(job.state, *wanted)) {
    queue_.change(job.id, JobState::printing, "");
    if (wanted == JobState::printing) return true;
  }
  queue_.change(job.id, *wanted, state.why, is_over(state) ? filament_used(job, state) : 0);
  return true;
}

void Spooler::changed() {
  ++version_;
  snapshot_.reset();
  changed_.notify_all();
}

}  // namespace spooler
