// SPDX-License-Identifier: Apache-2.0
// A project of two entities and a package, with proofs of every kind and mutations.
#pragma once

#include <filesystem>
#include <string>

#include "tests/temporary_folder.hpp"

class SmallProject {
 public:
  // With the programs that judge copied from this project.
  SmallProject();

  const std::filesystem::path& path() const { return folder_.path(); }
  void write(const std::filesystem::path& file, const std::string& text) const {
    folder_.write(file, text);
  }
  // Puts `to` in the place of the only `from` of a file.
  void change(const std::filesystem::path& file, const std::string& from,
              const std::string& to) const;
  std::filesystem::path table() const { return path() / "testbench" / "proofs" / "recorded.tsv"; }

 private:
  TemporaryFolder folder_;
};
