// SPDX-License-Identifier: Apache-2.0
// Where a user's locks are, and which folders are rejected for them.
#include "tools/files/private_folder.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "tests/temporary_folder.hpp"
#include "tools/files/path_lock.hpp"

namespace {

namespace fs = std::filesystem;

class PrivateFolderTest : public testing::Test {
 protected:
  PrivateFolderTest() { setenv("XDG_RUNTIME_DIR", runtime.c_str(), 1); }
  static fs::path of_this_user() { return "/tmp/stepfabric-" + std::to_string(geteuid()); }

  const TemporaryFolder temporary;
  fs::path runtime = temporary.path();
};

TEST_F(PrivateFolderTest, lies_in_the_runtime_folder_with_mode_0700) {
  const files::PrivateFolder folder;
  EXPECT_EQ(folder.path(), runtime / "stepfabric");
  EXPECT_EQ(fs::status(folder.path()).permissions(), fs::perms::owner_all);
}

TEST_F(PrivateFolderTest, lies_in_tmp_under_the_users_number_where_there_is_no_runtime_folder) {
  fs::permissions(runtime, fs::perms::owner_all | fs::perms::others_exec);
  EXPECT_EQ(files::PrivateFolder().path(), of_this_user());
  fs::permissions(runtime, fs::perms::owner_all);
  for (const char* name : {"", "relative/folder", "/no/such/folder"}) {
    setenv("XDG_RUNTIME_DIR", name, 1);
    EXPECT_EQ(files::PrivateFolder().path(), of_this_user()) << name;
  }
  unsetenv("XDG_RUNTIME_DIR");
  EXPECT_EQ(files::PrivateFolder().path(), of_this_user());
}

TEST_F(PrivateFolderTest, is_refused_where_others_may_write_or_a_symlink_or_file_stands) {
  const fs::path place = runtime / "stepfabric";
  fs::create_directory(place);
  fs::permissions(place, fs::perms::owner_all | fs::perms::group_write);
  EXPECT_THROW(files::PrivateFolder(), std::runtime_error);
  fs::remove(place);
  fs::create_directory(runtime / "elsewhere");
  fs::permissions(runtime / "elsewhere", fs::perms::owner_all);
  fs::create_directory_symlink(runtime / "elsewhere", place);
  EXPECT_THROW(files::PrivateFolder(), std::runtime_error);
  fs::remove(place);
  std::ofstream(place) << "precious";
  EXPECT_THROW(files::PrivateFolder(), std::runtime_error);
  EXPECT_EQ(fs::file_size(place), 8U);
}

// Only root can make one.
TEST_F(PrivateFolderTest, is_refused_where_it_is_another_users) {
  const fs::path place = runtime / "stepfabric";
  fs::create_directory(place);
  fs::permissions(place, fs::perms::owner_all);
  constexpr uid_t another_user = 65'534;
  if (geteuid() != 0 || chown(place.c_str(), another_user, another_user) != 0) {
    GTEST_SKIP() << "this user cannot give a folder to another user";
  }
  EXPECT_THROW(files::PrivateFolder(), std::runtime_error);
}

TEST_F(PrivateFolderTest, holds_locks_that_follow_no_link_and_know_every_spelling_of_a_path) {
  const fs::path path = runtime / "port";
  fs::path lock_file;
  {
    files::PathLock lock(path);
    lock.note("left");
    for (const auto& entry : fs::directory_iterator(runtime / "stepfabric")) {
      lock_file = entry.path();
    }
    EXPECT_THROW(files::PathLock(runtime / "." / ".." / runtime.filename() / "port"),
                 std::runtime_error);
  }
  ASSERT_FALSE(lock_file.empty());
  EXPECT_FALSE(fs::exists(lock_file));
  std::ofstream(runtime / "victim") << "precious";
  fs::create_symlink(runtime / "victim", lock_file);
  EXPECT_THROW(files::PathLock{path}, std::system_error);
  fs::remove(lock_file);
  fs::create_hard_link(runtime / "victim", lock_file);
  EXPECT_THROW(files::PathLock{path}, std::runtime_error);
  EXPECT_EQ(fs::file_size(runtime / "victim"), 8U);
}

}  // namespace
