// SPDX-License-Identifier: Apache-2.0
// Opens the queue as the next worker does.
#include "tests/host/acknowledged.hpp"

#include <algorithm>
#include <exception>
#include <sstream>

#include "host/queue/queue.hpp"
#include "host/queue/store.hpp"
#include "tests/host/known_text.hpp"
#include "tools/files/file_text.hpp"

namespace host_test {

namespace {

using queue::JobState;

std::string numbered(queue::JobId id, const std::string& rest) {
  return "job " + std::to_string(id) + " " + rest;
}

}  // namespace

void Acknowledged::hear(const std::string& text) {
  std::istringstream lines(text.substr(0, text.rfind('\n') + 1));
  std::string word;
  queue::JobId id = 0;
  while (lines >> word >> id) {
    if (word == "added") lines >> added_[id];
    if (word == "sent") ++sent_[id];
  }
}

std::string Acknowledged::violation(const std::filesystem::path& folder) const {
  try {
    queue::Queue jobs(folder / "queue.db");
    const queue::Store store(folder / "files");
    for (const std::string& file : store.files()) {
      if (!is_known_text(files::text_of(store.path_of(file)))) return file + " is not whole";
    }
    for (const auto& [id, bytes] : added_) {
      const auto job = jobs.find(id);
      if (!job) return numbered(id, "is lost");
      if (job->bytes != bytes) return numbered(id, "has another size");
      std::error_code missing;
      if (std::filesystem::file_size(store.path_of(job->file), missing) !=
          static_cast<std::uintmax_t>(bytes)) {
        return numbered(id, "has not its file");
      }
    }
    for (const auto& [id, times] : sent_) {
      if (times != 1) return numbered(id, "was sent twice");
      const auto job = jobs.find(id);
      if (!job) return numbered(id, "was sent and is lost");
      if (job->state != JobState::finished && !is_active(job->state) &&
          job->state != JobState::interrupted) {
        return numbered(id, "was sent and is " + std::string(name_of(job->state)));
      }
    }
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

}  // namespace host_test
