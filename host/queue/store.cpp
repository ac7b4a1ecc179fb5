// SPDX-License-Identifier: Apache-2.0
// Files written under a temporary name, synchronised, renamed.
#include "host/queue/store.hpp"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "host/queue/random_name.hpp"

namespace queue {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view temporary_ending = ".part";
constexpr std::size_t longest_name = 120;

[[noreturn]] void fail(const std::string& what) {
  throw std::system_error(errno, std::generic_category(), what);
}

bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0u) == 0x80u; }

}  // namespace

std::string random_name() {
  std::array<unsigned char, 12> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    fail("no random bytes");
  }
  std::string name;
  for (const unsigned char byte : bytes) {
    constexpr std::string_view digits = "0123456789abcdef";
    name += digits[byte >> 4u];
    name += digits[byte & 15u];
  }
  return name;
}

void sync_folder(const fs::path& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) fail("cannot open " + folder.string());
  const bool synced = fsync(descriptor) == 0;
  const int error = errno;
  close(descriptor);
  errno = error;
  if (!synced) fail("cannot synchronise " + folder.string());
}

void make_folder(const fs::path& folder) {
  fs::path path = fs::absolute(folder).lexically_normal();
  if (!path.has_filename()) {
    path = path.parent_path();  // a slash at its end
  }
  const fs::path above = path.parent_path();
  if (above == path) return;
  const bool was_there = fs::is_directory(path);
  if (!was_there) {
    make_folder(above);
    // Another process may have made it meanwhile.
    if (mkdir(path.c_str(), 0700) != 0) {
      const int error = errno;
      if (error != EEXIST || !fs::is_directory(path)) {
        throw std::system_error(error, std::generic_category(), "cannot make " + path.string());
      }
    }
  }
  // Also where it was there: who made it may have been killed before this.
  try {
    sync_folder(above);
  } catch (const std::system_error& error) {
    // Not for this user to read: it is older than this program.
    const bool is_refused = error.code() == std::errc::permission_denied ||
                            error.code() == std::errc::operation_not_permitted;
    if (!was_there || !is_refused) throw;
  }
}

std::string cleaned_name(std::string_view name) {
  if (const auto slash = name.find_last_of("/\\"); slash != std::string_view::npos) {
    name.remove_prefix(slash + 1);
  }
  std::string cleaned;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte != 0x7f) cleaned += c;
  }
  cleaned.erase(0, std::min(cleaned.find_first_not_of(". "), cleaned.size()));
  if (cleaned.size() > longest_name) {
    std::size_t end = longest_name;
    while (end > 0 && continues_character(cleaned[end])) --end;
    cleaned.resize(end);
  }
  while (!cleaned.empty() && cleaned.back() == ' ') cleaned.pop_back();
  return cleaned.empty() ? "unnamed.gcode" : cleaned;
}

Store::Store(fs::path folder) : folder_(std::move(folder)) {
  make_folder(folder_);
  fs::permissions(folder_, fs::perms::owner_all);
}

void Store::remove(const std::string& file) const { fs::remove(path_of(file)); }

std::size_t Store::remove_all_but(const std::vector<std::string>& in_use) const {
  std::vector<fs::path> unused;
  for (const auto& entry : fs::directory_iterator(folder_)) {
    const std::string name = entry.path().filename().string();
    const bool is_part = name.ends_with(temporary_ending);
    if (is_part || !std::ranges::contains(in_use, name.substr(0, name.find('.')) + ".gcode")) {
      unused.push_back(entry.path());
    }
  }
  for (const fs::path& file : unused) fs::remove(file);
  return unused.size();
}

std::vector<std::string> Store::files() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_)) {
    std::string name = entry.path().filename().string();
    if (!name.ends_with(temporary_ending)) names.push_back(std::move(name));
  }
  return names;
}

Store::Upload::Upload(const Store& store) : Upload(store, random_name() + ".gcode") {}

Store::Upload::Upload(const Store& store, std::string name)
    : store_(store), name_(std::move(name)) {
  const fs::path temporary = store_.path_of(name_ + std::string(temporary_ending));
  file_ = open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (file_ < 0) fail("cannot write " + temporary.string());
}

Store::Upload::~Upload() {
  if (file_ < 0) return;
  close(file_);
  unlink(store_.path_of(name_ + std::string(temporary_ending)).c_str());
}

void Store::Upload::write(std::span<const char> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(file_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail("cannot write the upload");
    bytes = bytes.subspan(static_cast<std::size_t>(count));
    bytes_ += count;
  }
}

std::string Store::Upload::keep() {
  if (fsync(file_) != 0) fail("cannot synchronise the upload");
  const fs::path temporary = store_.path_of(name_ + std::string(temporary_ending));
  fs::rename(temporary, store_.path_of(name_));
  close(file_);
  file_ = -1;
  sync_folder(store_.folder_);
  return name_;
}

}  // namespace queue
