// SPDX-License-Identifier: Apache-2.0
// The spooler: checks what is uploaded, gives jobs to printers, and follows them. It knows no web.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/queue/queue.hpp"
#include "host/queue/store.hpp"
#include "host/spooler/background.hpp"
#include "host/spooler/checker.hpp"
#include "host/spooler/feeder_link.hpp"
#include "host/spooler/settings.hpp"

namespace spooler {

struct NoSuchPrinter : std::runtime_error {
  explicit NoSuchPrinter(const std::string& name)
      : std::runtime_error("there is no printer " + name) {}
};
// The printer or its feeder does not do what is asked now.
struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The upload is not in the queue: it may be sent again.
struct NotAdded : queue::Unavailable {
  using Unavailable::Unavailable;
};

// The queue that the settings name: a file of this spooler's, or a server's, which others have too.
queue::Queue queue_of(const Settings& settings);
Checker::Publish publish_of(const Settings& settings);

// All calls are for any thread. Apart from the exceptions above they throw those of queue::Queue.
class Spooler {
 public:
  // Throws std::runtime_error where another spooler has the folder, or where folder or database
  // cannot be used.
  explicit Spooler(Settings settings);
  ~Spooler();
  Spooler(const Spooler&) = delete;
  Spooler& operator=(const Spooler&) = delete;

  // Works until `ended` says so.
  void run(const std::function<bool()>& ended);

  const queue::Store& store() const { return store_; }
  // The job is committed when it returns, and its file with it. Throws queue::Unavailable where it
  // is not, and queue::OutcomeUnknown where that cannot be found out.
  queue::JobId add(queue::Store::Upload& upload, const std::string& name, bool held,
                   const std::string& printer);

  void cancel(queue::JobId id);
  void move(queue::JobId id, std::optional<queue::JobId> next);
  void set_held(queue::JobId id, bool held);
  // An interrupted one is queued again, with its number. `printer`: where another one is wanted.
  queue::JobId print_again(queue::JobId id, const std::optional<std::string>& printer = {});
  void rename(queue::JobId id, const std::string& name);
  // Which printer may start it; empty: any.
  void set_wanted_printer(queue::JobId id, const std::string& printer);
  void remove(queue::JobId id);
  std::optional<queue::Job> find(queue::JobId id);
  std::vector<queue::Job> jobs();
  std::vector<queue::Change> history(queue::JobId id);

  // Refused where the bed has a print on it. "Not clear" while a job starts is written down and
  // refused: the start may have left already. Where it has not, the job is queued again.
  void set_bed_clear(const std::string& printer, bool clear);
  // What is left on its spool, in mm; nothing: not known, and no job waits for it.
  void set_filament_left(const std::string& printer, std::optional<double> millimetres);
  // pause, resume, cancel, stop, or send with a line. A stop, also as M112, waits for nothing that
  // the spooler does, such as a database that hangs.
  void ask(const std::string& printer, const nlohmann::json& wish);
  // Switches a simulated printer off and on.
  void restart(const std::string& printer);
  std::vector<std::string> printer_names() const;
  // Of the data's disk, in bytes.
  std::filesystem::space_info disk_space() const;
  std::uintmax_t free_bytes() const { return disk_space().available; }
  // The last minutes of its heaters: TemperatureLog::to_json().
  nlohmann::json temperatures(const std::string& printer);
  // What the job's check has drawn: the path of its file (tools/planning/path_file.hpp), and a
  // picture of it (PNG). Nothing where there is none, as before the check's end or where
  // nothing is extruded.
  std::optional<std::filesystem::path> path_of(queue::JobId id);
  std::optional<std::filesystem::path> picture_of(queue::JobId id);

  // Everything for people, as JSON, with its version.
  struct Snapshot {
    std::int64_t version{};
    std::string text;
    nlohmann::json json;
  };
  std::shared_ptr<const Snapshot> snapshot();
  // Waits until its version is another one, or for this time.
  std::shared_ptr<const Snapshot> next_snapshot(std::int64_t version,
                                                std::chrono::milliseconds time);

 private:
  class FolderLock {
   public:
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();

   private:
    int file_;
  };

  struct FailedCheck {
    int attempts = 0;  // in a row
    std::chrono::steady_clock::time_point again_at;
    std::string fault;
  };

  // What people see of the queue.
  struct View {
    std::vector<queue::Job> jobs;
    std::set<std::string> clear_beds;
    std::map<std::string, double> filaments;  // left, in mm
    std::vector<queue::Lease> leases;
    bool is_old = false;  // the database is away
    bool operator==(const View&) const = default;
  };

  bool keep_leases();
  void release_leases();
  bool look_at_others();
  bool is_time_to_look() const;
  bool has_files(const std::vector<std::filesystem::path>& files, const queue::Job& job);
  bool end_fetch();
  void share(const std::string& file);
  queue::JobId find_added(const std::string& file, const std::string& why);
  void check_known(const std::string& printer);
  View read_view();

  void recover();
  void keep_files_of_a_lost_queue();
  bool pass();
  bool check_files();
  void note_check(const CheckResult& result);
  bool forget_failed_checks();
  bool follow(FeederLink& printer);
  void stop(const std::string& printer);
  bool end_clear_bed(const std::string& printer);
  void start_next(FeederLink& printer);
  void send_start(FeederLink& printer, const queue::Job& job);
  bool follow_job(FeederLink& printer, const queue::Job& job, const FeederState& state);
  double filament_used(const queue::Job& job, const FeederState& state) const;
  FeederLink& link(const std::string& printer);
  // Of each job its own: a check of the same file for another job leaves it alone.
  std::filesystem::path commands_of(const queue::Job& job) const;
  std::optional<std::filesystem::path> made_of(queue::JobId id, const char* ending);
  void changed();
  nlohmann::json to_json(const FeederLink& printer);
  nlohmann::json others_to_json() const;

  Settings settings_;
  FolderLock lock_;
  queue::Store store_;
  queue::Queue queue_;
  Checker checker_;
  std::vector<std::unique_ptr<FeederLink>> printers_;
  std::map<std::string, std::chrono::steady_clock::time_point> blocked_until_;
  // Of the job on each printer, the most that its feeder has said: a new feeder does not know it.
  struct Progress {
    queue::JobId job{};
    std::int64_t done{};
    std::int64_t since{};  // commands done when it was last said how much filament is left
  };
  std::map<std::string, Progress> progress_;

  // Of a queue with several spoolers.
  Background fetcher_;
  std::string fetch_fault_;
  std::map<std::string, std::string> lease_refusals_;  // by printer; empty: it is held
  std::chrono::steady_clock::time_point renew_at_{}, look_at_{}, fetch_at_{};
  View view_;
  std::int64_t viewed_ms_ = 0;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::string fault_;  // of the last pass; empty: none
  std::map<queue::JobId, FailedCheck> failed_checks_;  // of jobs that wait for another attempt
  std::string notice_;  // of the start; shown where there is no fault
  std::int64_t version_ = 1;
  std::shared_ptr<const Snapshot> snapshot_;
};

}  // namespace spooler
