// SPDX-License-Identifier: Apache-2.0
// The durable queue of jobs. Each call that changes something has reached the disk when it returns.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "host/queue/database.hpp"
#include "host/queue/job.hpp"
#include "host/queue/lease.hpp"

namespace queue {

// A change that the table of transitions or the present state does not permit; nothing has changed.
struct NotPermitted : std::runtime_error {
  using std::runtime_error::runtime_error;
};
// No job has this number.
struct NoSuchJob : std::runtime_error {
  explicit NoSuchJob(JobId id) : std::runtime_error("there is no job " + std::to_string(id)) {}
};

// Another spooler has the printer, or this one was away for longer than its lease.
struct LeaseLost : NotPermitted {
  using NotPermitted::NotPermitted;
};

struct NewJob {
  std::string name;
  std::string file;
  std::int64_t bytes{};
  bool held = false;
  std::string wanted_printer{};
};

// For one thread at a time. Calls throw std::runtime_error where the database fails, and NoSuchJob.
class Queue {
 public:
  // In this file (SQLite), of one spooler.
  explicit Queue(const std::filesystem::path& database);
  // Of several spoolers, each with a number of its own.
  Queue(std::unique_ptr<Database> database, Member member);

  // At the end of the order.
  JobId add(const NewJob& job);
  std::optional<Job> find(JobId id);
  // In their order; `final_limit`: at most so many that are over, the latest ones.
  std::vector<Job> jobs(std::int64_t final_limit = 1000);
  // The same without the results of checks, which may be long.
  std::vector<Job> overview(std::int64_t final_limit);
  std::vector<Change> history(JobId id);

  // The state `to`, as the table permits; throws NotPermitted. Not for `starting`: start().
  // `filament_mm`: what the job's printer has used of it.
  void change(JobId id, JobState to, std::string_view why, double filament_mm = 0);
  // queued -> starting on this printer, whose bed then counts as occupied. Throws NotPermitted
  // where the job is held, wants another printer, the bed is not clear, too little filament is
  // left, or the printer has an active job.
  void start(JobId id, const std::string& printer);
  // The same where it is still the next one for this printer. False where it is not, as where
  // another spooler was faster.
  bool start_if_next(JobId id, const std::string& printer);
  // starting -> queued: not a byte has left, so the bed is as free as before, unless a person has
  // said meanwhile that it is not clear.
  void take_back(JobId id, std::string_view why);
  // The next job that may start on this printer.
  std::optional<Job> next_for(const std::string& printer);
  std::optional<Job> active_on(const std::string& printer);

  void set_check(JobId id, std::string_view check, double seconds, double filament_mm,
                 std::int64_t commands);
  void set_held(JobId id, bool held);
  // Before `next`, or to the end. Throws NotPermitted once it has been started.
  void move(JobId id, std::optional<JobId> next);
  // A name for people, as queue::cleaned_name() makes it.
  void rename(JobId id, const std::string& name);
  // Which printer may start it; empty: any. Throws NotPermitted once it has been started.
  void set_wanted_printer(JobId id, const std::string& printer);
  // A job that is over and was not refused, as a new one at the end, for the same printer or this.
  JobId print_again(JobId id, const std::optional<std::string>& printer = {});
  // Forgets a job that is over. Its file may go where files_in_use() no longer has it.
  void remove(JobId id);
  // Of the jobs, and those of keep_files().
  std::vector<std::string> files_in_use();
  // False as long as no job was ever added.
  bool has_had_jobs();
  // Files of the store that are of no job and must never be removed.
  void keep_files(const std::vector<std::string>& files);

  bool bed_is_clear(const std::string& printer);
  // It was clear when the last job was started, and no one has said anything else since.
  bool bed_is_taken(const std::string& printer);
  void set_bed_clear(const std::string& printer, bool clear);
  // Printers with a clear bed.
  std::set<std::string> clear_beds();
  // When that of a printer was said to be clear, in ms since 1970; nothing where it is not clear.
  std::optional<std::int64_t> clear_since(const std::string& printer);

  // Filament that a person says is left, less what jobs have used since, in mm; nothing where it is
  // not known, and then it limits no job.
  std::optional<double> filament_left(const std::string& printer);
  void set_filament_left(const std::string& printer, std::optional<double> millimetres);
  std::map<std::string, double> filaments_left();
  bool has_filament_for(const Job& job, const std::string& printer);

  // What several spoolers need (leases.cpp). Without them each lease is held.
  bool is_shared() const { return member_.has_value(); }
  // The lease of a printer that this one has not. Empty: it is held now; elsewhere why not. Where
  // another spooler had it, the printer's active job becomes `interrupted` and its bed not clear.
  std::string claim(const std::string& printer);
  // All that are held, to be called several times in their time; those that another spooler has got
  // meanwhile are not held any more. Takes over the checks of spoolers that are away.
  void renew();
  // Those of printers without an active job.
  void release();
  bool holds(const std::string& printer) const;
  // Until when at least it is held, by boot_ms(). Without other spoolers: the highest number.
  std::int64_t held_until(const std::string& printer) const;
  std::vector<Lease> leases();
  // Jobs that this spooler is to check, or has checked.
  std::set<JobId> checks();
  // The first job of an upload, to find out whether an add() of unknown outcome was committed.
  std::optional<JobId> job_of_upload(const std::string& file);

 private:
  JobId insert(const NewJob& job);
  void write_start(const Job& job, const std::string& printer);
  std::vector<Job> jobs_with(const std::string& result, std::int64_t final_limit);
  void join();
  void take_check(JobId id);
  void delete_with_files(const Job& job);
  void require_lease(const std::string& printer);  // throws LeaseLost
  void require_check(const Job& job, JobState to);  // throws NotPermitted
  void set_state(const Job& job, JobState to, std::string_view why);
  Job found(JobId id);
  void check_waits(JobId id);  // throws NotPermitted
  std::int64_t read_bed(const std::string& printer);
  void write_bed(const std::string& printer, std::int64_t bed);
  void use_filament(const std::string& printer, double millimetres);
  void write_change(const Job& job, JobState to, std::string_view why);

  std::unique_ptr<Database> database_;
  std::optional<Member> member_;
  struct Held {
    std::int64_t token{};
    std::int64_t until_ms{};  // by boot_ms()
  };
  std::map<std::string, Held> held_;  // by printer
};

}  // namespace queue
