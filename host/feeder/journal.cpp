// SPDX-License-Identifier: Apache-2.0
// The journal as a JSON file.
#include "host/feeder/journal.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

namespace feeder {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t slot_bytes = 8192;

constexpr std::array<std::string_view, 8> names{"opening",  "running",   "paused", "cancelling",
                                                "finished", "cancelled", "failed", "interrupted"};

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

void sync_and_close(int descriptor, const fs::path& path) {
  const bool synced = fsync(descriptor) == 0;
  close(descriptor);
  if (!synced) fail("cannot synchronise " + path.string());
}

void sync_folder_of(const fs::path& file) {
  const int folder = open(file.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) fail("cannot open " + file.parent_path().string());
  sync_and_close(folder, file.parent_path());
}

}  // namespace

std::string_view name_of(Phase phase) { return names.at(static_cast<std::size_t>(phase)); }

std::optional<Phase> phase_named(std::string_view name) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names.at(i) == name) return static_cast<Phase>(i);
  }
  return std::nullopt;
}

Journal::Journal(fs::path file) : file_(std::move(file)) {
  if (!fs::exists(file_)) return;
  try {
    std::ifstream stream(file_);
    const auto json = nlohmann::json::parse(stream);
    record_ = Record{.job = json.at("job"),
                     .file = json.at("file"),
                     .commands = json.at("commands"),
                     .base = json.at("base"),
                     .phase = phase_named(json.at("phase").get<std::string>()).value(),
                     .why = json.at("why"),
                     .outcome = phase_named(json.at("outcome").get<std::string>()).value(),
                     .hotend_to_restore = json.value("hotend_to_restore", 0.0)};
  } catch (const std::exception& error) {
    const std::string aside = file_.string() + ".damaged";
    fs::rename(file_, aside);
    damage_ = "the feeder's journal was damaged and the job that it named is lost; it is kept as " +
              aside + " (" + error.what() + ")";
  }
}

// Padded, so that a later and longer record needs no more space. What follows the JSON is blanks.
void Journal::fill_spare(std::string text) const {
  text.resize(std::max(text.size(), slot_bytes), ' ');
  const int descriptor = open(spare().c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
  if (descriptor < 0) fail("cannot write " + spare().string());
  const auto size = static_cast<ssize_t>(text.size());
  if (::write(descriptor, text.data(), text.size()) != size || ftruncate(descriptor, size) != 0) {
    close(descriptor);
    fail("cannot write " + spare().string());
  }
  sync_and_close(descriptor, spare());
}

void Journal::put(const Record& record) const {
  const nlohmann::json json{{"job", record.job},
                            {"file", record.file},
                            {"commands", record.commands},
                            {"base", record.base},
                            {"phase", name_of(record.phase)},
                            {"why", record.why},
                            {"outcome", name_of(record.outcome)},
                            {"hotend_to_restore", record.hotend_to_restore}};
  fill_spare(json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  const bool exchanged =
      renameat2(AT_FDCWD, spare().c_str(), AT_FDCWD, file_.c_str(), RENAME_EXCHANGE) == 0;
  if (!exchanged) {  // the first one, or a file system that cannot exchange
    fs::rename(spare(), file_);
    try {
      fill_spare({});
    } catch (const std::system_error&) {
      if (!record_) fs::remove(file_);
      throw;
    }
  }
  sync_folder_of(file_);
}

void Journal::write(const Record& record) {
  put(record);
  record_ = record;
  fault_.clear();
  damage_.clear();
}

void Journal::note(const Record& record) {
  record_ = record;
  fault_ = "not written yet";
  retry();
}

void Journal::retry() {
  if (fault_.empty() || !record_) return;
  try {
    put(*record_);
    fault_.clear();
  } catch (const std::system_error& error) {
    fault_ = error.what();
  }
}

void Journal::clear() {
  fs::remove(file_);
  sync_folder_of(file_);
  record_.reset();
  fault_.clear();
}

}  // namespace feeder
