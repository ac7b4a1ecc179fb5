// SPDX-License-Identifier: Apache-2.0
// Which VHDL file needs which others, so that a mutant is tried on what it can change, and only
// again where something of that has changed.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace proof {

class SourceTree {
 public:
  // Reads all .vhd files of the folders. The name of each file is that of its unit.
  explicit SourceTree(const std::vector<std::filesystem::path>& folders);

  bool has(const std::string& unit) const { return files_.contains(unit); }
  const std::filesystem::path& file_of(const std::string& unit) const;
  const std::string& text_of(const std::string& unit) const;
  // What the unit itself calls `work.NAME`.
  const std::set<std::string>& needs_of(const std::string& unit) const { return file(unit).needs; }
  // The unit and all that it needs, directly or not; in alphabetical order.
  std::set<std::string> closure_of(const std::string& unit) const;
  std::vector<std::string> units() const;

  // Another file or another text takes the place of the unit's.
  void replace(const std::string& unit, const std::filesystem::path& path, const std::string& text);

 private:
  struct File {
    std::filesystem::path path;
    std::string text;
    std::set<std::string> needs;
  };
  const File& file(const std::string& unit) const;
  std::map<std::string, File> files_;
};

// 128 bits as hexadecimal digits; equal for equal texts on every machine.
std::string fingerprint(std::string_view text);

}  // namespace proof
