// SPDX-License-Identifier: Apache-2.0
// Which files of the store are still needed.
#include "host/queue/queue.hpp"

namespace queue {

std::vector<std::string> Queue::files_in_use() {
  Statement rows(database_, "SELECT file FROM jobs UNION SELECT file FROM kept_files");
  std::vector<std::string> files;
  while (rows.step()) files.push_back(rows.text(0));
  return files;
}

bool Queue::has_had_jobs() {
  return Statement(database_, "SELECT 1 FROM sqlite_sequence WHERE name = 'jobs'").step();
}

void Queue::keep_files(const std::vector<std::string>& files) {
  Transaction transaction(database_);
  for (const std::string& file : files) {
    Statement(database_, "INSERT OR IGNORE INTO kept_files(file) VALUES(?)").bind(file).run();
  }
  transaction.commit();
}

}  // namespace queue
