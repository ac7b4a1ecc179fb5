// SPDX-License-Identifier: Apache-2.0
// A file is written as a whole, or what was there stays.
#include "tools/files/write_file.hpp"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

#include "sim/report/accept_log.hpp"
#include "sim/report/edge_file.hpp"
#include "tests/temporary_folder.hpp"
#include "tools/files/file_text.hpp"

namespace {

namespace fs = std::filesystem;

class WriteFile : public testing::Test {
 protected:
  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }

  const TemporaryFolder temporary;
  fs::path folder = temporary.path();
  fs::path file = folder / "report.json";
};

TEST_F(WriteFile, makes_folders_and_replaces_what_was_there) {
  files::write_file(folder / "a" / "b", "first");
  files::write_file(folder / "a" / "b", "second");
  EXPECT_EQ(files::text_of(folder / "a" / "b"), "second");
  fs::create_symlink(folder / "a" / "b", file);
  files::write_file(file, "third");
  EXPECT_TRUE(fs::is_symlink(file));
  EXPECT_EQ(files::text_of(folder / "a" / "b"), "third");
  EXPECT_NO_THROW(files::write_file("/dev/null", "fourth"));
  EXPECT_TRUE(fs::exists("/dev/null"));
}

// In a folder that everyone can write, say.
TEST_F(WriteFile, follows_no_symlink_of_another_user) {
  const fs::path mine = folder / "mine";
  std::ofstream(mine) << "precious";
  fs::create_symlink(mine, file);
  constexpr uid_t another_user = 65'534;
  if (lchown(file.c_str(), another_user, another_user) != 0) {
    GTEST_SKIP() << "only root can give a link away";
  }
  EXPECT_THROW(files::write_file(file, "text"), std::runtime_error);
  EXPECT_THROW(report::EdgeFile{file}, std::runtime_error);
  EXPECT_THROW(report::AcceptLog{file}, std::runtime_error);
  EXPECT_EQ(files::text_of(mine), "precious");
  EXPECT_EQ(files(), 2U);
}

TEST_F(WriteFile, leaves_the_file_of_before_and_nothing_else_where_the_disk_is_full) {
  files::write_file(file, "before");
  signal(SIGXFSZ, SIG_IGN);
  rlimit old{};
  getrlimit(RLIMIT_FSIZE, &old);
  const rlimit small{1000, old.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_THROW(files::write_file(file, std::string(5000, 'x')), std::runtime_error);
  setrlimit(RLIMIT_FSIZE, &old);
  signal(SIGXFSZ, SIG_DFL);
  EXPECT_EQ(files::text_of(file), "before");
  EXPECT_EQ(files(), 1U);
}

TEST_F(WriteFile, touches_no_neighbour_with_a_name_like_its_own) {
  const fs::path neighbour = folder / (".report.json." + std::to_string(getpid()) + ".0");
  std::ofstream(neighbour) << "precious";
  files::write_file(file, "text");
  EXPECT_EQ(files::text_of(neighbour), "precious");
  EXPECT_EQ(files::text_of(file), "text");
}

TEST_F(WriteFile, refuses_a_folder_and_a_full_device) {
  fs::create_directory(file);
  EXPECT_THROW(files::write_file(file, "text"), std::runtime_error);
  EXPECT_THROW(files::write_file("/dev/full", "text"), std::runtime_error);
  EXPECT_THROW(report::EdgeFile("/dev/full"), std::runtime_error);
}

}  // namespace
