// SPDX-License-Identifier: Apache-2.0
// What is done where several spoolers have one queue: leases, files of others, what others changed.
#include <algorithm>
#include <fstream>

#include "host/queue/postgres_database.hpp"
#include "host/queue/random_name.hpp"
#include "host/queue/shared_files.hpp"
#include "host/spooler/spooler.hpp"
#include "host/spooler/spooler_id.hpp"
#include "tools/files/write_file.hpp"

namespace spooler {

using queue::Job;
using std::chrono::steady_clock;

namespace {

constexpr int renewals = 5;  // in the time of a lease
constexpr std::chrono::milliseconds look_interval{300};
constexpr std::chrono::seconds fetch_interval{5}, longest_lookup{15}, lookup_interval{1};
constexpr const char* release_fault = "its lease could not be given back: ";

}  // namespace

queue::Queue queue_of(const Settings& settings) {
  // Files, journals and numbers of jobs in the folder are of one queue.
  const std::filesystem::path own = settings.data / "queue.db";
  if (settings.database.empty()) {
    if (!std::filesystem::exists(own) && std::filesystem::exists(settings.data / spooler_id_file)) {
      throw std::runtime_error(
          settings.data.string() +
          " was used with --database: without it name another folder by --data");
    }
    return queue::Queue(own);
  }
  if (std::filesystem::exists(own)) {
    throw std::runtime_error(
        settings.data.string() +
        " has a queue of its own: for --database name another folder by --data");
  }
  return {std::make_unique<queue::PostgresDatabase>(settings.database),
          queue::Member{.id = spooler_id(settings.data),
                        .boot = queue::boot_id(),
                        .place = settings.place,
                        .lease_time = settings.lease_time}};
}

Checker::Publish publish_of(const Settings& settings) {
  if (settings.database.empty()) return {};
  return [address = settings.database](std::int64_t job, const std::filesystem::path& commands) {
    queue::SharedFiles shared(address);
    for (const char* ending : {path_ending, picture_ending}) {
      const auto drawn = std::filesystem::path(commands).replace_extension(ending);
      if (std::filesystem::exists(drawn)) shared.put(drawn.filename(), drawn, job);
    }
    shared.put(commands.filename(), commands, job);
  };
}

// True where something has changed for people.
bool Spooler::keep_leases() {
  const auto now = steady_clock::now();
  if (!queue_.is_shared() || now < renew_at_) return false;
  queue_.renew();
  bool is_changed = false;
  for (const auto& printer : printers_) {
    std::string& refusal = lease_refusals_[printer->name()];
    std::string present;
    if (!queue_.holds(printer->name())) present = queue_.claim(printer->name());
    is_changed |= present != refusal;
    refusal = std::move(present);
  }
  renew_at_ = now + settings_.lease_time / renewals;
  return is_changed;
}

void Spooler::release_leases() {
  try {
    queue_.release();
  } catch (const std::exception& error) {  // they end by themselves
    notice_ = release_fault + std::string(error.what());
  }
}

// What other spoolers have changed is shown soon. True where something is new.
bool Spooler::look_at_others() {
  const auto now = steady_clock::now();
  if (!queue_.is_shared() || now < look_at_) return false;
  look_at_ = now + look_interval;
  View fresh = read_view();
  const bool is_new = view_.is_old || fresh != view_;
  if (is_new) view_ = std::move(fresh);
  return is_new;
}

// True where the queue is looked at in this pass: another machine's is asked less often.
bool Spooler::is_time_to_look() const {
  return !queue_.is_shared() || steady_clock::now() >= look_at_;
}

// True where all files are on this disk. Elsewhere they are being fetched.
bool Spooler::has_files(const std::vector<std::filesystem::path>& files, const Job& job) {
  if (!queue_.is_shared()) return true;
  if (std::ranges::all_of(files, [](const auto& file) { return std::filesystem::exists(file); })) {
    return true;
  }
  if (!fetcher_.is_idle() || steady_clock::now() < fetch_at_) return false;
  fetcher_.begin([this, id = job.id, file = job.file, is_checked = job.commands > 0] {
    queue::SharedFiles shared(settings_.database);
    const auto wanted = is_checked ? shared.made_for(id) : std::vector<std::string>{file};
    if (wanted.empty()) {
      throw std::runtime_error("the commands of job " + std::to_string(id) + " are nowhere");
    }
    for (const std::string& name : wanted) {
      if (!std::filesystem::exists(store_.path_of(name))) shared.fetch(name, store_);
    }
  });
  return false;
}

// Throws what the last fetch has thrown.
bool Spooler::end_fetch() {
  if (const auto fault = fetcher_.take_fault()) {
    fetch_at_ = steady_clock::now() + (fault->empty() ? std::chrono::seconds(0) : fetch_interval);
    fetch_fault_ = *fault;
  }
  // Shown until it is tried again, where the job still waits.
  if (steady_clock::now() >= fetch_at_) fetch_fault_.clear();
  if (!fetch_fault_.empty()) throw std::runtime_error(fetch_fault_);
  return false;
}

// In the queue's database, before the job is committed.
void Spooler::share(const std::string& file) {
  if (!queue_.is_shared()) return;
  try {
    queue::SharedFiles(settings_.database).put(file, store_.path_of(file));
  } catch (...) {
    store_.remove(file);
    throw;
  }
}

// It is not added again: it may be there already.
queue::JobId Spooler::find_added(const std::string& file, const std::string& why) {
  const auto end = steady_clock::now() + longest_lookup;
  while (steady_clock::now() < end) {
    std::this_thread::sleep_for(lookup_interval);
    const std::scoped_lock lock(mutex_);
    try {
      if (const auto id = queue_.job_of_upload(file)) return *id;
      throw NotAdded("the connection to the queue's database was lost before the commit");
    } catch (const NotAdded&) {
      throw;
    } catch (const queue::Unavailable&) {  // later
    }
  }
  throw queue::OutcomeUnknown(why + "; look into the queue before you upload it again");
}

// Throws NoSuchPrinter where no spooler has it.
void Spooler::check_known(const std::string& printer) {
  const bool is_of_another = std::ranges::any_of(view_.leases, [&](const queue::Lease& lease) {
    return lease.printer == printer && !lease.is_mine;
  });
  if (!is_of_another) link(printer);
}

}  // namespace spooler
