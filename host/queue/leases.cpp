// SPDX-License-Identifier: Apache-2.0
// Leases by the server's clock. Each has a token that grows with every holder: who comes with an
// old one writes nothing.
#include "host/queue/lease.hpp"

#include <time.h>

#include <algorithm>
#include <fstream>
#include <limits>

#include "host/queue/bed.hpp"
#include "host/queue/queue.hpp"

namespace queue {

namespace {

const std::string server_ms = "(extract(epoch FROM clock_timestamp()) * 1000)::bigint";

// A spooler at work renews several times in the time of a lease: more is left only where the
// server's clock was set back since.
bool is_running(std::int64_t left_ms, std::chrono::milliseconds lease_time) {
  return left_ms > 0 && left_ms <= 2 * lease_time.count();
}

}  // namespace

std::int64_t boot_ms() {
  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  return std::int64_t{now.tv_sec} * 1000 + now.tv_nsec / 1'000'000;
}

std::string boot_id() {
  std::string id;
  std::ifstream("/proc/sys/kernel/random/boot_id") >> id;
  return id;
}

void Queue::join() {
  Transaction transaction(*database_);
  // A copy of a whole disk has its number too; two of one number would share their printers.
  Statement row(*database_, "SELECT place, ends_ms - " + server_ms +
                                " FROM spoolers WHERE id = ? AND boot <> ?");
  row.bind(member_->id).bind(member_->boot);
  if (row.step() && is_running(row.integer(1), member_->lease_time)) {
    throw std::runtime_error("a spooler with the number of this one is at work on " + row.text(0) +
                             ": remove the file spooler_id in the folder of --data where that is a "
                             "copy; after a restart of the machine wait some seconds");
  }
  Statement(*database_, "INSERT INTO spoolers(id, boot, place, ends_ms) VALUES(?, ?, ?, " +
                            server_ms +
                            " + ?) ON CONFLICT(id) DO UPDATE SET boot = excluded.boot, "
                            "place = excluded.place, ends_ms = excluded.ends_ms")
      .bind(member_->id)
      .bind(member_->boot)
      .bind(member_->place)
      .bind(member_->lease_time.count())
      .run();
  // Uploads of which no job was committed.
  Statement(*database_,
            "DELETE FROM files WHERE made < now() - interval '1 day' AND NOT EXISTS"
            "(SELECT 1 FROM jobs WHERE jobs.file = files.name) AND NOT EXISTS"
            "(SELECT 1 FROM made_files WHERE made_files.file = files.name)")
      .run();
  transaction.commit();
}

std::string Queue::claim(const std::string& printer) {
  if (!member_) return {};
  const std::int64_t before_ms = boot_ms();
  Transaction transaction(*database_);
  Statement row(*database_, "SELECT spooler, leases.boot, token, leases.ends_ms - " + server_ms +
                                ", place FROM leases JOIN spoolers ON spoolers.id = spooler "
                                "WHERE printer = ?");
  row.bind(printer);
  std::int64_t token = 1;
  if (row.step()) {
    const bool was_mine = row.text(0) == member_->id;
    // The lock of its folder says that the process which had it is gone.
    const bool may_go_on = was_mine && row.text(1) == member_->boot;
    const std::int64_t left_ms = row.integer(3);
    if (is_running(left_ms, member_->lease_time) && !may_go_on) {
      return "printer " + printer + " belongs to the spooler on " + row.text(4) +
             ", whose lease ends in " + std::to_string(left_ms / 1000 + 1) +
             " s unless it is renewed";
    }
    token = row.integer(2) + 1;
    if (!was_mine) {
      if (const auto job = active_on(printer)) {
        set_state(*job, JobState::interrupted,
                  "the lease of the spooler on " + row.text(4) +
                      " has ended: how far it was printed there is not known");
      }
      write_bed(printer, static_cast<std::int64_t>(Bed::not_clear));
    }
  }
  Statement(*database_,
            "INSERT INTO leases(printer, spooler, boot, token, ends_ms) "
            "VALUES(?, ?, ?, ?, " +
                server_ms +
                " + ?) ON CONFLICT(printer) DO UPDATE SET spooler = excluded.spooler, "
                "boot = excluded.boot, token = excluded.token, "
                "ends_ms = excluded.ends_ms")
      .bind(printer)
      .bind(member_->id)
      .bind(member_->boot)
      .bind(token)
      .bind(member_->lease_time.count())
      .run();
  transaction.commit();
  held_[printer] = {.token = token, .until_ms = before_ms + member_->lease_time.count()};
  return {};
}

void Queue::renew() {
  if (!member_) return;
  const std::int64_t until_ms = boot_ms() + member_->lease_time.count();
  Transaction transaction(*database_);
  Statement(*database_, "UPDATE spoolers SET ends_ms = " + server_ms + " + ? WHERE id = ?")
      .bind(member_->lease_time.count())
      .bind(member_->id)
      .run();
  std::map<std::string, Held> held;
  for (const auto& [printer, lease] : held_) {
    Statement mine(*database_, "UPDATE leases SET ends_ms = " + server_ms +
                                   " + ? WHERE printer = ? AND spooler = ? AND token = ?");
    mine.bind(member_->lease_time.count()).bind(printer).bind(member_->id).bind(lease.token);
    if (mine.run() > 0) held[printer] = {.token = lease.token, .until_ms = until_ms};
  }
  // The checks of spoolers that are away.
  Statement(*database_,
            "UPDATE checks SET spooler = ? WHERE spooler IN "
            "(SELECT id FROM spoolers WHERE ends_ms < " +
                server_ms +
                ") AND job IN (SELECT id FROM jobs WHERE state IN "
                "('uploaded', 'checking'))")
      .bind(member_->id)
      .run();
  transaction.commit();
  held_ = std::move(held);
}

void Queue::release() {
  if (!member_) return;
  Transaction transaction(*database_);
  for (const auto& [printer, lease] : held_) {
    if (active_on(printer)) continue;
    Statement(*database_,
              "UPDATE leases SET ends_ms = 0 WHERE printer = ? AND spooler = ? "
              "AND token = ?")
        .bind(printer)
        .bind(member_->id)
        .bind(lease.token)
        .run();
  }
  transaction.commit();
  held_.clear();
}

bool Queue::holds(const std::string& printer) const { return !member_ || held_.contains(printer); }

std::int64_t Queue::held_until(const std::string& printer) const {
  if (!member_) return std::numeric_limits<std::int64_t>::max();
  const auto lease = held_.find(printer);
  return lease == held_.end() ? 0 : lease->second.until_ms;
}

void Queue::require_lease(const std::string& printer) {
  if (!member_) return;
  const auto lease = held_.find(printer);
  if (lease != held_.end()) {
    Statement row(*database_,
                  "SELECT 1 FROM leases WHERE printer = ? AND spooler = ? AND "
                  "token = ? AND ends_ms > " +
                      server_ms);
    row.bind(printer).bind(member_->id).bind(lease->second.token);
    if (row.step()) return;
  }
  throw LeaseLost("this spooler has no lease of printer " + printer + " now");
}

std::vector<Lease> Queue::leases() {
  std::vector<Lease> all;
  if (!member_) return all;
  Statement rows(*database_, "SELECT printer, place, spooler, leases.ends_ms - " + server_ms +
                                 " FROM leases JOIN spoolers ON spoolers.id = spooler "
                                 "ORDER BY printer");
  while (rows.step()) {
    all.push_back({.printer = rows.text(0),
                   .place = rows.text(1),
                   .is_mine = rows.text(2) == member_->id,
                   .is_over = rows.integer(3) <= 0});
  }
  return all;
}

void Queue::take_check(JobId id) {
  Statement(*database_, "INSERT INTO checks(job, spooler) VALUES(?, ?)")
      .bind(id)
      .bind(member_->id)
      .run();
}

std::set<JobId> Queue::checks() {
  std::set<JobId> mine;
  if (!member_) return mine;
  Statement rows(*database_, "SELECT job FROM checks WHERE spooler = ?");
  rows.bind(member_->id);
  while (rows.step()) mine.insert(rows.integer(0));
  return mine;
}

// By a person it is cancelled from any spooler.
void Queue::require_check(const Job& job, JobState to) {
  if (!member_ || to == JobState::cancelled) return;
  Statement row(*database_, "SELECT 1 FROM checks WHERE job = ? AND spooler = ?");
  row.bind(job.id).bind(member_->id);
  if (!row.step()) {
    throw NotPermitted("job " + std::to_string(job.id) + " is checked by another spooler");
  }
}

}  // namespace queue
