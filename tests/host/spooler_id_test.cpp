// SPDX-License-Identifier: Apache-2.0
// Two spoolers never have one number, whatever becomes of their folders.
#include "host/spooler/spooler_id.hpp"

#include <gtest/gtest.h>

#include "tests/temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using spooler::spooler_id;

TEST(SpoolerId, stays_with_its_folder_and_not_with_a_copy) {
  const TemporaryFolder folder;
  const fs::path data = folder.path() / "data", copy = folder.path() / "copy";
  fs::create_directory(data);
  const std::string id = spooler_id(data);
  EXPECT_FALSE(id.empty());
  EXPECT_EQ(spooler_id(data), id) << "after a restart";
  EXPECT_EQ(spooler_id(data / "." / ""), id) << "the same folder, written otherwise";
  fs::copy(data, copy, fs::copy_options::recursive);
  const std::string other = spooler_id(copy);
  EXPECT_NE(other, id);
  EXPECT_EQ(spooler_id(copy), other);
  EXPECT_EQ(spooler_id(data), id);
}

TEST(SpoolerId, is_new_where_another_folder_has_taken_the_place) {
  const TemporaryFolder folder;
  const fs::path data = folder.path() / "data", aside = folder.path() / "aside";
  fs::create_directory(data);
  const std::string id = spooler_id(data);
  fs::rename(data, aside);
  EXPECT_NE(spooler_id(aside), id) << "what was moved may run together with what takes its place";
  fs::copy(aside, data, fs::copy_options::recursive);
  EXPECT_NE(spooler_id(data), id);
}

}  // namespace
