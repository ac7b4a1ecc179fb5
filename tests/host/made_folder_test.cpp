// SPDX-License-Identifier: Apache-2.0
// A folder that was there already: its name reaches the disk all the same, for who made it may have
// been killed before.
#include <gtest/gtest.h>

#include <algorithm>

#include "directories.hpp"
#include "tests/host/power_loss/recording.hpp"
#include "tests/temporary_folder.hpp"
#include "tools/process/process.hpp"

namespace {

namespace fs = std::filesystem;
using power_loss::Kind;

struct Made {
  int status{};
  bool name_is_on_disk{};
};

// The path below a recorded folder, in which `above/spool` is.
Made made(const std::string& path, const std::string& fault = {}) {
  const TemporaryFolder folder;
  power_loss::Recording recording(folder.path(), fault);
  const fs::path above = recording.folder() / "above";
  fs::create_directories(above / "spool");
  recording.begin();
  const auto ending = process::run(
      {.arguments = {BUILD_DIRECTORY "/bin/queue_worker", (recording.folder() / path).string()},
       .output = folder.path() / "said"});
  const auto records = recording.end();
  const bool is_synced = std::ranges::any_of(records, [&](const power_loss::Record& record) {
    return record.head.kind == Kind::sync_folder && record.first == above;
  });
  return {.status = ending.exit_status, .name_is_on_disk = is_synced};
}

TEST(made_folder, has_its_name_on_the_disk_however_the_path_is_written) {
  for (const char* path : {"above/spool", "above/spool/", "above/./spool/.", "above/spool//"}) {
    const Made folder = made(path);
    EXPECT_EQ(folder.status, 0) << path;
    EXPECT_TRUE(folder.name_is_on_disk) << path;
  }
}

TEST(made_folder, is_refused_where_the_disk_fails) {
  EXPECT_EQ(made("above/spool", "folder_sync_error").status, 1);
}

}  // namespace
