// SPDX-License-Identifier: Apache-2.0
// Uploads that are there whole or not at all, and names that lead nowhere else.
#include "host/queue/store.hpp"

#include <gmock/gmock.h>

#include "tests/temporary_folder.hpp"
#include "tools/files/file_text.hpp"

namespace {

namespace fs = std::filesystem;
using queue::cleaned_name;
using queue::Store;

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

TEST(store, keeps_an_upload_under_a_new_name_for_this_user_alone) {
  const TemporaryFolder folder;
  const Store store(folder.path() / "files");
  Store::Upload upload(store);
  upload.write(std::string_view("G28\n"));
  upload.write(std::string_view("G1 X5\n"));
  EXPECT_EQ(upload.bytes(), 10);
  const std::string file = upload.keep();
  EXPECT_EQ(files::text_of(store.path_of(file)), "G28\nG1 X5\n");
  EXPECT_EQ(files_in(folder.path() / "files"), 1u);
  EXPECT_EQ(fs::status(store.path_of(file)).permissions() & fs::perms::others_all, fs::perms::none);
}

TEST(store, leaves_nothing_of_an_upload_that_was_given_up) {
  const TemporaryFolder folder;
  const Store store(folder.path() / "files");
  {
    Store::Upload upload(store);
    upload.write(std::string_view("G28\n"));
    EXPECT_EQ(files_in(folder.path() / "files"), 1u);
  }
  EXPECT_EQ(files_in(folder.path() / "files"), 0u);
}

TEST(store, removes_what_no_job_uses) {
  const TemporaryFolder folder;
  const Store store(folder.path() / "files");
  std::vector<std::string> kept;
  for (int i = 0; i < 2; ++i) kept.push_back(Store::Upload(store).keep());
  folder.write("files/" + kept[0].substr(0, 24) + ".12.commands", "G28\n");
  folder.write("files/" + kept[1].substr(0, 24) + ".commands", "G28\n");
  folder.write("files/0123.gcode.part", "G2");
  EXPECT_EQ(store.remove_all_but({kept[0]}), 3u);
  EXPECT_TRUE(fs::exists(store.path_of(kept[0])));
  EXPECT_EQ(files_in(folder.path() / "files"), 2u) << "the file and its commands";
}

TEST(store, leaves_a_file_alone_that_has_the_name_of_its_folder) {
  const TemporaryFolder folder;
  folder.write("files", "mine");
  const auto mode = fs::perms::owner_read | fs::perms::group_read;
  fs::permissions(folder.path() / "files", mode);
  EXPECT_THROW(Store(folder.path() / "files"), std::system_error);
  EXPECT_EQ(fs::status(folder.path() / "files").permissions(), mode);
  EXPECT_THROW(queue::make_folder(folder.path() / "files" / "below"), std::system_error);
}

TEST(cleaned_name, names_no_other_folder) {
  EXPECT_EQ(cleaned_name("../../etc/passwd"), "passwd");
  EXPECT_EQ(cleaned_name("..\\..\\boot.ini"), "boot.ini");
  EXPECT_EQ(cleaned_name("/"), "unnamed.gcode");
  EXPECT_EQ(cleaned_name(".."), "unnamed.gcode");
  EXPECT_EQ(cleaned_name("a/.."), "unnamed.gcode");
  EXPECT_EQ(cleaned_name("..."), "unnamed.gcode");
  EXPECT_EQ(cleaned_name(".hidden"), "hidden");
  EXPECT_EQ(cleaned_name(""), "unnamed.gcode");
  EXPECT_EQ(cleaned_name(std::string_view("a\0b\r\n.gcode", 11)), "ab.gcode");
}

TEST(cleaned_name, keeps_what_people_call_their_files) {
  EXPECT_EQ(cleaned_name("Vase mode (2).gcode"), "Vase mode (2).gcode");
  EXPECT_EQ(cleaned_name("Düse_ö.gcode"), "Düse_ö.gcode");
}

TEST(cleaned_name, cuts_a_long_name_between_characters) {
  std::string name = "x";
  for (int i = 0; i < 100; ++i) name += "ä";
  const std::string cleaned = cleaned_name(name);
  EXPECT_EQ(cleaned.size(), 119u);
  EXPECT_TRUE(name.starts_with(cleaned));
}

}  // namespace
