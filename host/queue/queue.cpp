// SPDX-License-Identifier: Apache-2.0
// Jobs and their changes as rows. The database itself refuses two active jobs on one printer.
#include "host/queue/queue.hpp"

#include "host/queue/bed.hpp"
#include "host/queue/now.hpp"
#include "host/queue/sqlite_database.hpp"
#include "host/queue/sqlite_tables.hpp"

namespace queue {

namespace {

// With this as the result of the check.
std::string columns_with(const std::string& result) {
  return "SELECT id, name, file, bytes, state, held, wanted_printer, printer, reason, " + result +
         ", seconds, filament_mm, commands, starts, uploaded_ms, changed_ms FROM jobs ";
}
const std::string columns = columns_with("result");
constexpr const char* final_states = "('refused', 'finished', 'cancelled', 'failed')";

Job job_of(const Statement& row) {
  const auto state = state_named(row.text(4));
  if (!state) throw std::runtime_error("job database: unknown state " + row.text(4));
  return {.id = row.integer(0),
          .name = row.text(1),
          .file = row.text(2),
          .bytes = row.integer(3),
          .state = *state,
          .held = row.integer(5) != 0,
          .wanted_printer = row.text(6),
          .printer = row.text(7),
          .reason = row.text(8),
          .check = row.text(9),
          .seconds = row.real(10),
          .filament_mm = row.real(11),
          .commands = row.integer(12),
          .starts = row.integer(13),
          .uploaded_ms = row.integer(14),
          .changed_ms = row.integer(15)};
}

std::vector<Job> jobs_of(Statement& statement) {
  std::vector<Job> found;
  while (statement.step()) found.push_back(job_of(statement));
  return found;
}

}  // namespace

std::string sentence(const Job& job, std::string_view rest) {
  return "job " + std::to_string(job.id) + " is " + std::string(name_of(job.state)) +
         std::string(rest);
}

Queue::Queue(const std::filesystem::path& database)
    : database_(std::make_unique<SqliteDatabase>(database)) {
  make_sqlite_tables(*database_);
}

Queue::Queue(std::unique_ptr<Database> database, Member member)
    : database_(std::move(database)), member_(std::move(member)) {
  join();
}

JobId Queue::add(const NewJob& job) {
  Transaction transaction(*database_);
  const JobId id = insert(job);
  transaction.commit();
  return id;
}

JobId Queue::insert(const NewJob& job) {
  const std::int64_t now = now_ms();
  Statement row(*database_,
                "INSERT INTO jobs(name, file, bytes, state, held, wanted_printer, printer, reason, "
                "result, seconds, filament_mm, commands, starts, uploaded_ms, changed_ms, place) "
                "VALUES(?, ?, ?, 'uploaded', ?, ?, '', '', '', 0, 0, 0, 0, ?, ?, "
                "(SELECT coalesce(max(place), 0) + 1 FROM jobs)) RETURNING id");
  row.bind(job.name)
      .bind(job.file)
      .bind(job.bytes)
      .bind(std::int64_t{job.held})
      .bind(job.wanted_printer)
      .bind(now)
      .bind(now)
      .step();
  const JobId id = row.integer(0);
  if (member_) take_check(id);
  return id;
}

std::optional<Job> Queue::find(JobId id) {
  Statement row(*database_, columns + "WHERE id = ?");
  row.bind(id);
  if (!row.step()) return std::nullopt;
  return job_of(row);
}

Job Queue::found(JobId id) {
  auto job = find(id);
  if (!job) throw NoSuchJob(id);
  return *std::move(job);
}

std::vector<Job> Queue::jobs(std::int64_t final_limit) { return jobs_with("result", final_limit); }
std::vector<Job> Queue::overview(std::int64_t final_limit) { return jobs_with("''", final_limit); }

std::vector<Job> Queue::jobs_with(const std::string& result, std::int64_t final_limit) {
  Statement rows(*database_, columns_with(result) + "WHERE state NOT IN " + final_states +
                                 " OR id IN (SELECT id FROM jobs WHERE state IN " + final_states +
                                 " ORDER BY changed_ms DESC, id DESC LIMIT ?) ORDER BY place, id");
  rows.bind(final_limit);
  return jobs_of(rows);
}

std::vector<Change> Queue::history(JobId id) {
  Statement rows(*database_,
                 "SELECT from_state, to_state, why, time_ms FROM changes WHERE job = ? "
                 "ORDER BY rowid");
  rows.bind(id);
  std::vector<Change> changes;
  while (rows.step()) {
    changes.push_back({.job = id,
                       .from = state_named(rows.text(0)).value(),
                       .to = state_named(rows.text(1)).value(),
                       .why = rows.text(2),
                       .time_ms = rows.integer(3)});
  }
  return changes;
}

void Queue::write_change(const Job& job, JobState to, std::string_view why) {
  if (!is_permitted(job.state, to)) {
    throw NotPermitted(sentence(job, " and cannot become ") + std::string(name_of(to)));
  }
  if (is_active(job.state)) require_lease(job.printer);
  if (job.state == JobState::uploaded || job.state == JobState::checking) require_check(job, to);
  set_state(job, to, why);
}

void Queue::set_state(const Job& job, JobState to, std::string_view why) {
  const std::int64_t now = now_ms();
  Statement(*database_, "UPDATE jobs SET state = ?, reason = ?, changed_ms = ? WHERE id = ?")
      .bind(name_of(to))
      .bind(why)
      .bind(now)
      .bind(job.id)
      .run();
  Statement(*database_,
            "INSERT INTO changes(job, from_state, to_state, why, time_ms) VALUES(?, ?, ?, ?, ?)")
      .bind(job.id)
      .bind(name_of(job.state))
      .bind(name_of(to))
      .bind(why)
      .bind(now)
      .run();
}

void Queue::change(JobId id, JobState to, std::string_view why, double filament_mm) {
  if (to == JobState::starting) throw NotPermitted("only start() makes a job `starting`");
  Transaction transaction(*database_);
  const Job job = found(id);
  write_change(job, to, why);
  if (filament_mm > 0) use_filament(job.printer, filament_mm);
  transaction.commit();
}

void Queue::start(JobId id, const std::string& printer) {
  Transaction transaction(*database_);
  write_start(found(id), printer);
  transaction.commit();
}

bool Queue::start_if_next(JobId id, const std::string& printer) {
  Transaction transaction(*database_);
  const auto next = next_for(printer);
  if (!next || next->id != id) return false;
  write_start(*next, printer);
  transaction.commit();
  return true;
}

void Queue::write_start(const Job& job, const std::string& printer) {
  require_lease(printer);
  if (job.held) throw NotPermitted(sentence(job, " and held"));
  if (!job.wanted_printer.empty() && job.wanted_printer != printer) {
    throw NotPermitted(sentence(job, " for another printer"));
  }
  if (!bed_is_clear(printer)) throw NotPermitted("the bed of " + printer + " is not clear");
  if (!has_filament_for(job, printer)) {
    throw NotPermitted(sentence(job, " and needs more filament than is left on " + printer));
  }
  if (active_on(printer)) throw NotPermitted(printer + " has a job");
  write_change(job, JobState::starting, "on " + printer);
  Statement(*database_, "UPDATE jobs SET printer = ?, starts = starts + 1 WHERE id = ?")
      .bind(printer)
      .bind(job.id)
      .run();
  write_bed(printer, static_cast<std::int64_t>(Bed::taken));
}

void Queue::take_back(JobId id, std::string_view why) {
  Transaction transaction(*database_);
  const Job job = found(id);
  if (job.state != JobState::starting) throw NotPermitted(sentence(job, ", not starting"));
  write_change(job, JobState::queued, why);
  Statement(*database_, "UPDATE jobs SET starts = starts - 1 WHERE id = ?").bind(id).run();
  if (bed_is_taken(job.printer)) write_bed(job.printer, static_cast<std::int64_t>(Bed::clear));
  transaction.commit();
}

std::optional<Job> Queue::next_for(const std::string& printer) {
  Statement row(*database_, columns +
                                "WHERE state = 'queued' AND held = 0 AND wanted_printer IN ('', ?) "
                                "ORDER BY place, id LIMIT 1");
  row.bind(printer);
  if (!row.step()) return std::nullopt;
  return job_of(row);
}

std::optional<Job> Queue::active_on(const std::string& printer) {
  Statement row(*database_,
                columns + "WHERE printer = ? AND state IN ('starting', 'printing', 'paused')");
  row.bind(printer);
  if (!row.step()) return std::nullopt;
  return job_of(row);
}

void Queue::set_check(JobId id, std::string_view check, double seconds, double filament_mm,
                      std::int64_t commands) {
  Transaction transaction(*database_);
  const auto changed =
      Statement(
          *database_,
          "UPDATE jobs SET result = ?, seconds = ?, filament_mm = ?, commands = ? WHERE id = ?")
          .bind(check)
          .bind(seconds)
          .bind(filament_mm)
          .bind(commands)
          .bind(id)
          .run();
  if (changed == 0) throw NoSuchJob(id);
  transaction.commit();
}

}  // namespace queue
