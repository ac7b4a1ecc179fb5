// SPDX-License-Identifier: Apache-2.0
// What people change of jobs: order, name, printer.
#include "host/queue/queue.hpp"

namespace queue {

void Queue::check_waits(JobId id) {
  const Job job = found(id);
  if (is_final(job.state) || is_active(job.state)) {
    throw NotPermitted(sentence(job, " and no longer waits"));
  }
}

void Queue::set_held(JobId id, bool held) {
  Transaction transaction(*database_);
  check_waits(id);
  Statement(*database_, "UPDATE jobs SET held = ? WHERE id = ?")
      .bind(std::int64_t{held})
      .bind(id)
      .run();
  transaction.commit();
}

void Queue::move(JobId id, std::optional<JobId> next) {
  Transaction transaction(*database_);
  check_waits(id);
  std::int64_t place = 0;
  if (next) {
    found(*next);
    Statement of_next(*database_, "SELECT place FROM jobs WHERE id = ?");
    of_next.bind(*next);
    of_next.step();
    place = of_next.integer(0);
    Statement(*database_, "UPDATE jobs SET place = place + 1 WHERE place >= ?").bind(place).run();
  } else {
    Statement last(*database_, "SELECT coalesce(max(place), 0) + 1 FROM jobs");
    last.step();
    place = last.integer(0);
  }
  Statement(*database_, "UPDATE jobs SET place = ? WHERE id = ?").bind(place).bind(id).run();
  transaction.commit();
}

void Queue::rename(JobId id, const std::string& name) {
  Transaction transaction(*database_);
  Statement named(*database_, "UPDATE jobs SET name = ? WHERE id = ?");
  if (named.bind(name).bind(id).run() == 0) throw NoSuchJob(id);
  transaction.commit();
}

void Queue::set_wanted_printer(JobId id, const std::string& printer) {
  Transaction transaction(*database_);
  check_waits(id);
  Statement(*database_, "UPDATE jobs SET wanted_printer = ? WHERE id = ?")
      .bind(printer)
      .bind(id)
      .run();
  transaction.commit();
}

JobId Queue::print_again(JobId id, const std::optional<std::string>& printer) {
  Transaction transaction(*database_);
  const Job job = found(id);
  if (job.state == JobState::refused || !is_final(job.state)) {
    throw NotPermitted(sentence(job, " and cannot be printed again"));
  }
  const JobId again = insert({.name = job.name,
                              .file = job.file,
                              .bytes = job.bytes,
                              .held = false,
                              .wanted_printer = printer.value_or(job.wanted_printer)});
  transaction.commit();
  return again;
}

void Queue::remove(JobId id) {
  Transaction transaction(*database_);
  const Job job = found(id);
  if (!is_final(job.state)) throw NotPermitted(sentence(job, " and not over"));
  if (member_) {
    delete_with_files(job);
  } else {
    Statement(*database_, "DELETE FROM jobs WHERE id = ?").bind(id).run();
  }
  transaction.commit();
}

}  // namespace queue
