// SPDX-License-Identifier: Apache-2.0
// The journal as a JSON file.
#include "host/feeder/journal.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

namespace feeder {

namespace fs = std::filesystem;

namespace {

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
  std::ifstream stream(file_);
  if (!stream) return;
  try {
    const auto json = nlohmann::json::parse(stream);
    record_ = Record{.job = json.at("job"),
                     .file = json.at("file"),
                     .commands = json.at("commands"),
                     .base = json.at("base"),
                     .phase = phase_named(json.at("phase").get<std::string>()).value(),
                     .why = json.at("why")};
  } catch (const std::exception& error) {
    throw std::runtime_error(file_.string() + " is no journal of a feeder: " + error.what());
  }
}

void Journal::write(const Record& record) {
  const nlohmann::json json{{"job", record.job},
                            {"file", record.file},
                            {"commands", record.commands},
                            {"base", record.base},
                            {"phase", name_of(record.phase)},
                            {"why", record.why}};
  const std::string text =
      json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  const fs::path temporary = file_.string() + ".new";
  const int descriptor = open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (descriptor < 0) fail("cannot write " + temporary.string());
  if (::write(descriptor, text.data(), text.size()) != static_cast<ssize_t>(text.size())) {
    close(descriptor);
    fail("cannot write " + temporary.string());
  }
  sync_and_close(descriptor, temporary);
  fs::rename(temporary, file_);
  sync_folder_of(file_);
  record_ = record;
}

void Journal::clear() {
  fs::remove(file_);
  sync_folder_of(file_);
  record_.reset();
}

}  // namespace feeder
