// SPDX-License-Identifier: Apache-2.0
// The files of the jobs. One is there whole or not at all, also after a loss of power.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace queue {

// What has been written to the folder's files and to the folder itself is on the disk afterwards.
// Throws std::system_error.
void sync_folder(const std::filesystem::path& folder);
// The folder and those above it are there, and their names are on the disk. Readable for this user
// alone where it was missing. Throws std::system_error, also where a file has its name.
void make_folder(const std::filesystem::path& folder);

// A file name for people, from what a client sends: its last component, without control characters,
// at most 120 bytes of whole UTF-8 characters, no dot in front; "unnamed.gcode" where nothing is
// left. It never names another folder.
std::string cleaned_name(std::string_view name);

class Store {
 public:
  // Made where it is missing, readable for this user alone. Throws std::system_error.
  explicit Store(std::filesystem::path folder);

  std::filesystem::path path_of(const std::string& file) const { return folder_ / file; }
  void remove(const std::string& file) const;
  // Removes what no job uses: uploads that did not end, and files whose job was never committed.
  // What else has the name of a file in use before its first dot, as the commands of its jobs, is
  // kept. Returns the number of removed files.
  std::size_t remove_all_but(const std::vector<std::string>& in_use) const;

  // Apart from uploads that did not end.
  std::vector<std::string> files() const;

  // A file on its way. Gone at the end of its scope unless it was kept. Throws std::system_error.
  class Upload {
   public:
    explicit Upload(const Store& store);
    // With a name that is known already, as of a file from another store. Takes the place of one.
    Upload(const Store& store, std::string name);
    ~Upload();
    Upload(const Upload&) = delete;
    Upload& operator=(const Upload&) = delete;
    void write(std::span<const char> bytes);
    std::int64_t bytes() const { return bytes_; }
    // Temporary name, fsync, rename, fsync of the folder: in this order. Returns the file's name in
    // the store. It remains until remove() or remove_all_but().
    std::string keep();

   private:
    const Store& store_;
    std::string name_;  // the final one
    int file_ = -1;
    std::int64_t bytes_ = 0;
  };

 private:
  std::filesystem::path folder_;
};

}  // namespace queue
