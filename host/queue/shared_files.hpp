// SPDX-License-Identifier: Apache-2.0
// Files in the queue's PostgreSQL database: what is uploaded at one spooler is printed by another.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/queue/job.hpp"
#include "host/queue/postgres_connection.hpp"
#include "host/queue/store.hpp"

namespace queue {

// For one thread at a time, with a connection of its own: a large file holds up no statement of the
// queue. In pieces: no file is held in memory. Throws as PostgresConnection does.
class SharedFiles {
 public:
  // Does not connect yet.
  explicit SharedFiles(const std::string& address) : connection_(address) {}

  // Whole or not at all, and on the server's disk when it returns. Takes the place of one with this
  // name. `job`: that it was made for; it goes with it. Without, a job must name it within a day.
  void put(const std::string& name, const std::filesystem::path& file,
           std::optional<JobId> job = {});
  // Into the store, whole or not at all, and on the disk when it returns. Throws
  // std::runtime_error where there is none of this name.
  void fetch(const std::string& name, const Store& store);
  // Names of the files that were made for this job.
  std::vector<std::string> made_for(JobId job);

 private:
  class Work;
  PostgresConnection connection_;
};

}  // namespace queue
