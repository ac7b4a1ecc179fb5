// SPDX-License-Identifier: Apache-2.0
// Which files of the store are still needed.
#include "host/queue/queue.hpp"

namespace queue {

std::vector<std::string> Queue::files_in_use() {
  Statement rows(*database_, is_shared()
                                 ? "SELECT DISTINCT file FROM jobs"
                                 : "SELECT file FROM jobs UNION SELECT file FROM kept_files");
  std::vector<std::string> files;
  while (rows.step()) files.push_back(rows.text(0));
  return files;
}

// The last job of an upload takes its content with it.
void Queue::delete_with_files(const Job& job) {
  std::vector<std::string> made;
  Statement rows(*database_, "SELECT file FROM made_files WHERE job = ?");
  rows.bind(job.id);
  while (rows.step()) made.push_back(rows.text(0));
  Statement(*database_, "DELETE FROM jobs WHERE id = ?").bind(job.id).run();
  for (const std::string& file : made) {
    Statement(*database_, "DELETE FROM files WHERE name = ?").bind(file).run();
  }
  Statement(*database_,
            "DELETE FROM files WHERE name = ? AND NOT EXISTS"
            "(SELECT 1 FROM jobs WHERE jobs.file = files.name)")
      .bind(job.file)
      .run();
}

std::optional<JobId> Queue::job_of_upload(const std::string& file) {
  // In a transaction, which waits for one of a lost connection.
  Transaction transaction(*database_);
  Statement row(*database_, "SELECT id FROM jobs WHERE file = ? ORDER BY id LIMIT 1");
  row.bind(file);
  if (!row.step()) return std::nullopt;
  return row.integer(0);
}

bool Queue::has_had_jobs() {
  return Statement(*database_, "SELECT 1 FROM sqlite_sequence WHERE name = 'jobs'").step();
}

void Queue::keep_files(const std::vector<std::string>& files) {
  Transaction transaction(*database_);
  for (const std::string& file : files) {
    Statement(*database_, "INSERT INTO kept_files(file) VALUES(?) ON CONFLICT DO NOTHING")
        .bind(file)
        .run();
  }
  transaction.commit();
}

}  // namespace queue
