// SPDX-License-Identifier: Apache-2.0
// What people ask of the spooler.
#include "host/feeder/typed_line.hpp"
#include "host/spooler/spooler.hpp"

namespace spooler {

using queue::Job;
using queue::JobId;
using queue::JobState;

namespace {

constexpr std::chrono::seconds answer_limit{5};

bool is_stop(const nlohmann::json& wish) {
  return wish.at("do") == "stop" ||
         (wish.at("do") == "send" && feeder::m_code_of(wish.at("line").get<std::string>()) == 112);
}

}  // namespace

JobId Spooler::add(queue::Store::Upload& upload, const std::string& name, bool held,
                   const std::string& printer) {
  if (!printer.empty()) {
    const std::scoped_lock lock(mutex_);
    check_known(printer);
  }
  const std::int64_t bytes = upload.bytes();
  const std::string file = upload.keep();
  share(file);
  try {
    const std::scoped_lock lock(mutex_);
    const JobId id = queue_.add({.name = queue::cleaned_name(name),
                                 .file = file,
                                 .bytes = bytes,
                                 .held = held,
                                 .wanted_printer = printer});
    changed();
    return id;
  } catch (const queue::OutcomeUnknown& error) {
    return find_added(file, error.what());
  }
}

void Spooler::cancel(JobId id) {
  std::string printer;
  bool interrupted = false;
  {
    const std::scoped_lock lock(mutex_);
    const auto job = queue_.find(id);
    if (!job) throw queue::NoSuchJob(id);
    const bool may_be_hot = job->state == JobState::interrupted || job->state == JobState::failed;
    const bool has_its_printer = !job->printer.empty() && !queue_.active_on(job->printer);
    if (!is_active(job->state) && !(may_be_hot && has_its_printer)) {
      queue_.change(id, JobState::cancelled, "by a person");
      changed();
      return;
    }
    if (is_active(job->state) && !queue_.holds(job->printer)) {
      throw Refused("job " + std::to_string(id) +
                    " is printed by another spooler: cancel it there");
    }
    printer = job->printer;
    interrupted = job->state == JobState::interrupted;
  }
  // Heaters first, and whatever became of the job: the feeder refuses it where it has another one.
  std::string why = "by a person";
  try {
    ask(printer, {{"do", "cancel"}, {"job", id}});
  } catch (const std::runtime_error& error) {  // the printer is away: go on
    if (!interrupted) throw;
    why += std::string("; ") + error.what();
  }
  if (!interrupted) return;
  const std::scoped_lock lock(mutex_);
  queue_.change(id, JobState::cancelled, why);
  changed();
}

void Spooler::move(JobId id, std::optional<JobId> next) {
  const std::scoped_lock lock(mutex_);
  queue_.move(id, next);
  changed();
}

void Spooler::set_held(JobId id, bool held) {
  const std::scoped_lock lock(mutex_);
  queue_.set_held(id, held);
  changed();
}

void Spooler::rename(JobId id, const std::string& name) {
  const std::scoped_lock lock(mutex_);
  queue_.rename(id, queue::cleaned_name(name));
  changed();
}

void Spooler::set_wanted_printer(JobId id, const std::string& printer) {
  const std::scoped_lock lock(mutex_);
  if (!printer.empty()) check_known(printer);
  queue_.set_wanted_printer(id, printer);
  changed();
}

JobId Spooler::print_again(JobId id, const std::optional<std::string>& printer) {
  const std::scoped_lock lock(mutex_);
  if (printer && !printer->empty()) check_known(*printer);
  const auto job = queue_.find(id);
  if (!job) throw queue::NoSuchJob(id);
  JobId again = id;
  if (job->state == JobState::interrupted) {
    if (printer) queue_.set_wanted_printer(id, *printer);
    queue_.change(id, JobState::queued, "a person wants it printed again");
  } else {
    again = queue_.print_again(id, printer);
  }
  changed();
  return again;
}

void Spooler::remove(JobId id) {
  const std::scoped_lock lock(mutex_);
  const auto job = queue_.find(id);
  if (!job) throw queue::NoSuchJob(id);
  queue_.remove(id);
  bool used = false;
  for (const std::string& file : queue_.files_in_use()) used |= file == job->file;
  remove_made_with(commands_of(*job));
  // What its check still reads is removed at the next start.
  const bool is_read = !checker_.is_idle() && checker_.job() == id;
  if (!used && !is_read) store_.remove(job->file);
  changed();
}

std::optional<Job> Spooler::find(JobId id) {
  const std::scoped_lock lock(mutex_);
  return queue_.find(id);
}

// Without the results of checks: of a thousand jobs these are many megabytes.
std::vector<Job> Spooler::jobs() {
  constexpr std::int64_t most_over = 1000;
  const std::scoped_lock lock(mutex_);
  return queue_.overview(most_over);
}

std::vector<queue::Change> Spooler::history(JobId id) {
  const std::scoped_lock lock(mutex_);
  if (!queue_.find(id)) throw queue::NoSuchJob(id);
  return queue_.history(id);
}

FeederLink& Spooler::link(const std::string& printer) {
  for (const auto& each : printers_) {
    if (each->name() == printer) return *each;
  }
  for (const queue::Lease& lease : view_.leases) {
    if (lease.printer != printer || lease.is_mine) continue;
    throw Refused("printer " + printer + " belongs to the spooler on " + lease.place +
                  ": do it there");
  }
  throw NoSuchPrinter(printer);
}

std::vector<std::string> Spooler::printer_names() const {
  std::vector<std::string> names;
  for (const auto& printer : printers_) names.push_back(printer->name());
  return names;
}

std::filesystem::space_info Spooler::disk_space() const {
  return std::filesystem::space(settings_.data);
}

void Spooler::set_bed_clear(const std::string& printer, bool clear) {
  const std::scoped_lock lock(mutex_);
  link(printer);
  const auto job = queue_.active_on(printer);
  if (clear && job) throw Refused("the bed has a print on it");
  queue_.set_bed_clear(printer, clear);
  changed();
  if (job && job->state == JobState::starting) {
    throw Refused("noted, but job " + std::to_string(job->id) +
                  " is being started there: cancel it");
  }
}

void Spooler::set_filament_left(const std::string& printer, std::optional<double> millimetres) {
  const std::scoped_lock lock(mutex_);
  const FeederState& state = link(printer).last_state();
  queue_.set_filament_left(printer, millimetres);
  if (const auto job = queue_.active_on(printer)) {
    const std::int64_t done = state.job == job->id ? state.done : 0;
    progress_[printer] = {.job = job->id, .done = done, .since = done};
  }
  changed();
}

void Spooler::restart(const std::string& printer) {
  const std::scoped_lock lock(mutex_);
  FeederLink& found = link(printer);
  if (!found.is_simulated()) throw Refused("switch the printer off and on by hand");
  found.restart_chip();
}

// The printers are the same from beginning to end.
void Spooler::stop(const std::string& printer) {
  for (const auto& each : printers_) {
    if (each->name() != printer) continue;
    if (const std::string refusal = each->stop(); !refusal.empty()) throw Refused(refusal);
    return;
  }
  const std::scoped_lock lock(mutex_);
  link(printer);
}

void Spooler::ask(const std::string& printer, const nlohmann::json& wish) {
  if (is_stop(wish)) return stop(printer);
  // The answer may come when this call waits no longer.
  struct Waiting {
    std::optional<std::string> refusal;
  };
  const auto waiting = std::make_shared<Waiting>();
  std::unique_lock lock(mutex_);
  FeederLink& found = link(printer);
  nlohmann::json whole = wish;
  // A feeder that has not heard of the job yet must not start it after its cancel.
  const bool feeder_has_one = found.last_state().job && !is_over(found.last_state());
  if (wish.at("do") == "cancel" && !wish.contains("job") && !feeder_has_one) {
    try {
      const auto job = queue_.active_on(printer);
      if (job && queue_.holds(printer)) whole["job"] = job->id;
    } catch (const queue::Unavailable&) {  // then by what the feeder knows
    }
  }
  found.ask(whole, [this, waiting](const std::string& refusal) {
    waiting->refusal = refusal;
    changed_.notify_all();
  });
  if (!changed_.wait_for(lock, answer_limit, [&] { return waiting->refusal.has_value(); })) {
    throw Refused("the printer's feeder does not answer");
  }
  if (!waiting->refusal->empty()) throw Refused(*waiting->refusal);
}

}  // namespace spooler
