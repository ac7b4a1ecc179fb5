// SPDX-License-Identifier: Apache-2.0
// Two states of each file and each name: what programs see, and what is on the disk.
#include "tests/host/power_loss/lossy_disk.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "tools/files/file_text.hpp"

namespace power_loss {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t sector = 512;

bool chance(std::mt19937& random, unsigned of) { return random() % of == 0; }

}  // namespace

std::vector<Record> records_of(const fs::path& log) {
  const std::string text = files::text_of(log);
  std::vector<Record> records;
  for (std::size_t at = 0; at + sizeof(Head) <= text.size();) {
    Record record;
    std::memcpy(&record.head, text.data() + at, sizeof(Head));
    const std::size_t begin = at + sizeof(Head);
    const std::size_t size = std::size_t{record.head.first_bytes} + record.head.second_bytes;
    if (record.head.magic != Head::right_magic || begin + size > text.size()) {
      ++at;  // its process was killed on the way
      continue;
    }
    record.first = text.substr(begin, record.head.first_bytes);
    record.second = text.substr(begin + record.head.first_bytes, record.head.second_bytes);
    records.push_back(std::move(record));
    at = begin + size;
  }
  return records;
}

LossyDisk::Entry& LossyDisk::file(std::uint64_t inode) {
  Entry& entry = files_[inode];
  if (!entry) entry = std::make_shared<File>();
  return entry;
}

void LossyDisk::apply(const Record& record) {
  const fs::path first = record.first, second = record.second;
  switch (record.head.kind) {
    case Kind::create:
      files_[record.head.inode] = std::make_shared<File>();
      return change({{first, file(record.head.inode)}});
    case Kind::make_folder:
      return change(
          {{first, std::make_shared<File>(File{.is_folder = true, .durable = {}, .pending = {}})}});
    case Kind::write:
      file(record.head.inode)->pending.push_back({.at = record.head.number, .bytes = record.first});
      return;
    case Kind::truncate:
      file(record.head.inode)
          ->pending.push_back({.is_truncate = true, .at = record.head.number, .bytes = {}});
      return;
    case Kind::sync: {
      File& synced = *file(record.head.inode);
      for (const Change& each : synced.pending) apply_to(synced.durable, each);
      if (!synced.pending.empty()) synced.is_restored = false;
      synced.pending.clear();
      return;
    }
    case Kind::sync_folder:
      return sync_folder(first);
    case Kind::rename: {
      if (first.parent_path() != second.parent_path()) {
        throw std::logic_error("a file changes its folder: " + first.string());
      }
      const auto known = now_.find(first);
      return change({{first, nullptr},
                     {second, known == now_.end() ? file(record.head.inode) : known->second}});
    }
    case Kind::exchange:
      return change({{first, now_.at(second)}, {second, now_.at(first)}});
    case Kind::remove:
      return change({{first, nullptr}});
    case Kind::said:
      return;
  }
}

void LossyDisk::skip(const Record& record) {
  const auto found = files_.find(record.head.inode);
  if (found != files_.end()) found->second->is_restored = false;
}

void LossyDisk::apply_to(std::string& bytes, const Change& change) {
  if (change.is_truncate) {
    bytes.resize(change.at);
    return;
  }
  if (bytes.size() < change.at + change.bytes.size()) bytes.resize(change.at + change.bytes.size());
  bytes.replace(change.at, change.bytes.size(), change.bytes);
}

void LossyDisk::apply_to(Names& names, const NameChange& change) {
  for (const auto& [path, entry] : change.names) {
    if (entry) {
      names[path] = entry;
    } else {
      names.erase(path);
    }
  }
}

void LossyDisk::change(Names names) {
  pending_.push_back({.names = std::move(names)});
  apply_to(now_, pending_.back());
}

void LossyDisk::sync_folder(const fs::path& folder) {
  std::erase_if(pending_, [&](const NameChange& each) {
    if (each.names.begin()->first.parent_path() != folder) return false;
    apply_to(durable_, each);
    return true;
  });
}

void LossyDisk::lose_power(File& file, std::mt19937& random) {
  if (file.pending.empty()) return;
  file.is_restored = false;
  const unsigned mode = random() % 4;
  const std::size_t whole = random() % (file.pending.size() + 1);  // of the third mode
  const unsigned share = 1 + random() % 4;
  for (std::size_t i = 0; i < file.pending.size(); ++i) {
    Change& each = file.pending[i];
    if (mode == 0) break;
    if (mode == 1 || (mode == 2 && i < whole) || (mode == 3 && each.is_truncate)) {
      apply_to(file.durable, each);
      continue;
    }
    if (mode == 2) {  // torn
      if (!each.is_truncate && !each.bytes.empty()) each.bytes.resize(random() % each.bytes.size());
      if (!each.is_truncate) apply_to(file.durable, each);
      break;
    }
    for (std::size_t begin = 0; begin < each.bytes.size();) {
      const std::size_t end =
          std::min(each.bytes.size(), ((each.at + begin) / sector + 1) * sector - each.at);
      if (chance(random, share)) {
        apply_to(file.durable,
                 {.at = each.at + begin, .bytes = each.bytes.substr(begin, end - begin)});
      }
      begin = end;
    }
  }
  file.pending.clear();
}

void LossyDisk::lose_power(std::mt19937& random) {
  const bool in_order = chance(random, 2);
  const std::size_t first_ones = random() % (pending_.size() + 1);
  for (std::size_t i = 0; i < pending_.size(); ++i) {
    if (in_order ? i < first_ones : chance(random, 2)) apply_to(durable_, pending_[i]);
  }
  pending_.clear();
  std::erase_if(durable_, [this](const auto& each) { return !is_reachable(each.first); });
  for (const auto& [path, entry] : durable_) lose_power(*entry, random);
  now_ = durable_;
}

// All folders above it are there.
bool LossyDisk::is_reachable(const fs::path& path) const {
  for (fs::path folder = path.parent_path(); folder != folder_; folder = folder.parent_path()) {
    if (!folder.has_relative_path()) {
      throw std::logic_error(path.string() + " is not below " + folder_.string());
    }
    if (!durable_.contains(folder)) return false;
  }
  return true;
}

void LossyDisk::restore() {
  std::vector<fs::path> lost;
  for (const auto& each : fs::recursive_directory_iterator(folder_)) {
    const bool is_kept = !each.is_symlink() && (each.is_regular_file() || each.is_directory());
    if (is_kept && !durable_.contains(each.path())) lost.push_back(each.path());
  }
  for (const fs::path& path : lost) fs::remove_all(path);
  const auto before = std::exchange(files_, {});
  for (const auto& [path, entry] : durable_) {  // a folder before what is in it
    if (entry->is_folder) {
      fs::create_directories(path);
      continue;
    }
    struct stat status{};
    const bool is_there = stat(path.c_str(), &status) == 0;
    const auto known = is_there ? before.find(status.st_ino) : before.end();
    if (known == before.end() || known->second != entry || !entry->is_restored) {
      std::ofstream(path, std::ios::binary) << entry->durable;
      fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
      entry->is_restored = true;
    }
    if (stat(path.c_str(), &status) != 0) throw std::runtime_error("cannot read " + path.string());
    files_[status.st_ino] = entry;
  }
}

}  // namespace power_loss
