// SPDX-License-Identifier: Apache-2.0
// What a queue_worker has said before it ended, and whether queue and store still have it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "host/queue/job.hpp"

namespace host_test {

class Acknowledged {
 public:
  // An incomplete last line was not said.
  void hear(const std::string& text);
  // The first violation of what must hold after a crash; empty: none.
  std::string violation(const std::filesystem::path& folder) const;

  std::size_t added() const { return added_.size(); }
  std::size_t sent() const { return sent_.size(); }

 private:
  std::map<queue::JobId, std::int64_t> added_;  // with their bytes
  std::map<queue::JobId, int> sent_;
};

}  // namespace host_test
