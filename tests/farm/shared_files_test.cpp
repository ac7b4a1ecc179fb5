// SPDX-License-Identifier: Apache-2.0
// Files through the database: whole, on any spooler, and not held in memory.
#include "host/queue/shared_files.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <random>

#include "tests/farm/farm_queue.hpp"
#include "tests/farm/postgres_server.hpp"
#include "tests/host/repetitions.hpp"
#include "tools/files/file_text.hpp"

namespace {

using queue::SharedFiles;
using queue::Store;

std::string random_bytes(std::size_t size) {
  std::mt19937 random(5);
  std::string text(size, '\0');
  for (char& byte : text) byte = static_cast<char>(random());
  return text;
}

// The most memory that this process has had since the last call, in KiB.
long highest_memory_kib() {
  long kib = 0;
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word && kib == 0;) {
    if (word == "VmHWM:") status >> kib;
  }
  std::ofstream("/proc/self/clear_refs") << "5";
  return kib;
}

class FilesInDatabase : public testing::Test {
 protected:
  std::string address = farm_test::shared_server().new_database();
  queue::Queue jobs = farm_test::open_farm(address, "a");
  TemporaryFolder folder;
  Store there{folder.path() / "there"};
  SharedFiles shared{address};

  std::filesystem::path file(const std::string& text) const {
    folder.write("upload", text);
    return folder.path() / "upload";
  }
};

TEST_F(FilesInDatabase, come_out_as_they_went_in) {
  constexpr std::size_t piece = 256 * 1024;
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, piece - 1, piece, 3 * piece + 7}) {
    const std::string text = random_bytes(size);
    shared.put("x.gcode", file(text));
    shared.fetch("x.gcode", there);
    EXPECT_TRUE(files::text_of(there.path_of("x.gcode")) == text) << size;
  }
}

TEST_F(FilesInDatabase, need_little_memory_however_large_they_are) {
  const auto mebibytes = static_cast<std::size_t>(host_test::number_of("SHARED_FILE_MIB", 48));
  {
    std::ofstream stream(folder.path() / "large", std::ios::binary);
    const std::string part = random_bytes(1024 * 1024);
    for (std::size_t i = 0; i < mebibytes; ++i) stream << part;
  }
  highest_memory_kib();
  const long before = highest_memory_kib();
  shared.put("large.gcode", folder.path() / "large");
  shared.fetch("large.gcode", there);
  EXPECT_LT(highest_memory_kib() - before, 16 * 1024);
  EXPECT_EQ(std::filesystem::file_size(there.path_of("large.gcode")), mebibytes * 1024 * 1024);
}

TEST_F(FilesInDatabase, a_missing_or_incomplete_one_is_no_file_in_the_store) {
  EXPECT_THROW(shared.fetch("none.gcode", there), std::runtime_error);
  shared.put("x.gcode", file(random_bytes(600'000)));
  farm_test::PostgresServer::execute(address, "DELETE FROM file_parts WHERE part = 1");
  EXPECT_THROW(shared.fetch("x.gcode", there), std::runtime_error);
  EXPECT_THAT(there.files(), testing::IsEmpty());
}

TEST_F(FilesInDatabase, no_job_is_committed_without_its_file) {
  EXPECT_THROW(jobs.add({.name = "x", .file = "none.gcode", .bytes = 1}), std::runtime_error);
  EXPECT_THAT(jobs.jobs(), testing::IsEmpty());
}

TEST_F(FilesInDatabase, go_with_the_last_job_that_needs_them) {
  const auto id = jobs.add(farm_test::uploaded(address, "x"));
  shared.put("x.1.commands", file("G28 X\n"), id);
  EXPECT_THAT(shared.made_for(id), testing::ElementsAre("x.1.commands"));
  jobs.change(id, queue::JobState::cancelled, "");
  const auto again = jobs.print_again(id);
  jobs.remove(id);
  EXPECT_THROW(shared.fetch("x.1.commands", there), std::runtime_error);
  EXPECT_NO_THROW(shared.fetch("x.gcode", there));
  jobs.change(again, queue::JobState::cancelled, "");
  jobs.remove(again);
  EXPECT_THROW(shared.fetch("x.gcode", there), std::runtime_error);
}

// Their upload was cut off; one of today may still be on its way.
TEST_F(FilesInDatabase, without_a_job_they_are_removed_a_day_later) {
  farm_test::uploaded(address, "new");
  farm_test::uploaded(address, "old");
  jobs.add(farm_test::uploaded(address, "used"));
  farm_test::PostgresServer::execute(
      address, "UPDATE files SET made = made - interval '25 hours' WHERE name <> 'new.gcode'");
  farm_test::open_farm(address, "b");
  EXPECT_NO_THROW(shared.fetch("new.gcode", there));
  EXPECT_NO_THROW(shared.fetch("used.gcode", there));
  EXPECT_THROW(shared.fetch("old.gcode", there), std::runtime_error);
}

}  // namespace
