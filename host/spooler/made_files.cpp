// SPDX-License-Identifier: Apache-2.0
// What a job's check makes of its file, next to the commands.
#include "host/spooler/spooler.hpp"

namespace spooler {

namespace fs = std::filesystem;

fs::path Spooler::commands_of(const queue::Job& job) const {
  return fs::absolute(store_.path_of(job.file))
      .replace_extension("." + std::to_string(job.id) + ".commands");
}

void remove_made_with(fs::path file) {
  fs::remove(file);
  for (const char* ending : {path_ending, picture_ending}) {
    fs::remove(file.replace_extension(ending));
  }
}

std::optional<fs::path> Spooler::made_of(queue::JobId id, const char* ending) {
  const std::scoped_lock lock(mutex_);
  const auto job = queue_.find(id);
  if (!job) throw queue::NoSuchJob(id);
  const fs::path file = commands_of(*job).replace_extension(ending);
  if (!fs::exists(file)) return std::nullopt;
  return file;
}

std::optional<fs::path> Spooler::path_of(queue::JobId id) { return made_of(id, path_ending); }

std::optional<fs::path> Spooler::picture_of(queue::JobId id) { return made_of(id, picture_ending); }

nlohmann::json Spooler::temperatures(const std::string& printer) {
  const std::scoped_lock lock(mutex_);
  return link(printer).temperatures().to_json();
}

}  // namespace spooler
