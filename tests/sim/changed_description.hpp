// SPDX-License-Identifier: Apache-2.0
// Machine descriptions with a mistake in them, and what a reader says of it.
#pragma once

#include <gmock/gmock.h>

#include <initializer_list>
#include <stdexcept>
#include <string>

#include "directories.hpp"
#include "tests/temporary_folder.hpp"
#include "tools/files/file_text.hpp"

namespace tests {

// The default machine's description with one text replaced by another.
inline std::string changed_description(const std::string& from, const std::string& to) {
  std::string text = files::text_of(PROJECT_DIRECTORY "/firmware/machines/prusa_mendel.toml");
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

// The error of `read`, which takes a path, for a file `changed_machine.toml` with this text; empty
// where it takes it.
template <typename Read>
std::string complaint_of(Read read, const std::string& text) {
  const TemporaryFolder folder;
  folder.write("changed_machine.toml", text);
  try {
    read(folder.path() / "changed_machine.toml");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

// `from` replaced by `to` makes a description of which `complaint` is said.
struct Mistake {
  std::string from, to, complaint;
};

template <typename Read>
void expect_complaints_of(Read read, std::initializer_list<Mistake> mistakes) {
  for (const Mistake& mistake : mistakes) {
    EXPECT_THAT(complaint_of(read, changed_description(mistake.from, mistake.to)),
                testing::HasSubstr(mistake.complaint))
        << mistake.from << " replaced by " << mistake.to;
  }
}

}  // namespace tests
