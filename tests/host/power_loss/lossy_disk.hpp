// SPDX-License-Identifier: Apache-2.0
// A disk that keeps after a loss of power what was synchronised, and anything of the rest: what
// POSIX promises, and no more.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "tests/host/power_loss/disk_record.hpp"

namespace power_loss {

struct Record {
  Head head;
  std::string first, second;
};

// Of a log; an unfinished record is skipped.
std::vector<Record> records_of(const std::filesystem::path& log);

class LossyDisk {
 public:
  // What is below the folder; it is empty, and itself on the disk.
  explicit LossyDisk(std::filesystem::path folder) : folder_(std::move(folder)) {}

  void apply(const Record& record);
  // It came after the loss, so what the folder has of its file is not to be trusted.
  void skip(const Record& record);
  // Of each file that is not synchronised: nothing, all, the first part of what was written with a
  // torn end, or any of its sectors of 512 bytes; of changes of names the first ones or any.
  void lose_power(std::mt19937& random);
  // Writes the state after the loss into the folder.
  void restore();

 private:
  struct Change {
    bool is_truncate = false;
    std::uint64_t at{};  // offset, or size
    std::string bytes;
  };
  struct File {
    bool is_folder = false;
    bool is_restored = false;  // the folder has it so
    std::string durable;
    std::vector<Change> pending;
  };
  using Entry = std::shared_ptr<File>;
  using Names = std::map<std::filesystem::path, Entry>;
  struct NameChange {
    Names names;  // of one folder; nothing: removed
  };

  static void apply_to(std::string& bytes, const Change& change);
  static void lose_power(File& file, std::mt19937& random);
  static void apply_to(Names& names, const NameChange& change);
  Entry& file(std::uint64_t inode);
  void change(Names names);
  void sync_folder(const std::filesystem::path& folder);
  bool is_reachable(const std::filesystem::path& path) const;

  std::filesystem::path folder_;
  Names now_, durable_;
  std::vector<NameChange> pending_;
  std::map<std::uint64_t, Entry> files_;  // by inode
};

}  // namespace power_loss
