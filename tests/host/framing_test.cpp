// SPDX-License-Identifier: Apache-2.0
// Lines on the wire, the file of commands, and the journal.
#include "host/feeder/framing.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <set>

#include "host/feeder/command_file.hpp"
#include "host/feeder/journal.hpp"
#include "tests/temporary_folder.hpp"
#include "tools/files/file_text.hpp"

namespace {

using namespace feeder;

TEST(framing, adds_number_and_checksum_as_hosts_do) {
  EXPECT_EQ(framed(0, "M110 N0"), "N0 M110 N0*125\n");
  EXPECT_EQ(framed(3, "T0"), "N3 T0*57\n");
}

TEST(framing, reads_what_printers_say) {
  EXPECT_EQ(resend_in("Resend: 17"), 17);
  EXPECT_EQ(resend_in("Resend:17"), 17);
  EXPECT_EQ(resend_in("rs N17"), 17);
  EXPECT_FALSE(resend_in("Resend: x"));
  EXPECT_FALSE(resend_in("ok 17"));
  Temperatures heat;
  EXPECT_TRUE(read_temperatures("ok T:201.25 /205.00 B:60.5 /60.00 @:12 B@:3", heat));
  EXPECT_EQ(heat.hotend, 201.25);
  EXPECT_EQ(heat.hotend_target, 205);
  EXPECT_EQ(heat.bed, 60.5);
  EXPECT_EQ(heat.bed_target, 60);
  EXPECT_EQ(heat.hotend_power, 12 / 127.0);
  EXPECT_EQ(heat.bed_power, 3 / 127.0);
  EXPECT_FALSE(read_temperatures("echo:busy: processing", heat));
  EXPECT_FALSE(read_temperatures("FIRMWARE_NAME:Marlin EXTRUDER_COUNT:1", heat));
  EXPECT_TRUE(is_fatal("Error:Thermal Runaway"));
  EXPECT_TRUE(is_fatal("!! halted"));
  EXPECT_FALSE(is_fatal("Error:checksum mismatch, Last Line: 5"));
  EXPECT_FALSE(is_fatal("echo:Unknown command"));
}

TEST(framing, reads_positions_and_nothing_else_as_such) {
  const auto position = position_in("X:10.50 Y:-2.25 Z:0.20 E:3.00 Count X:840 Y:-180 Z:512");
  ASSERT_TRUE(position);
  EXPECT_EQ(position->mm, (std::array{10.5, -2.25, 0.2, 3.0}));
  EXPECT_EQ(position->steps, (std::array<std::int64_t, 3>{840, -180, 512}));
  for (const char* other :
       {"echo:X:1 Y:1 Z:1 E:1 Count X:1 Y:1 Z:1", "X:1.00 Y:1.00 Z:1.00 E:1.00",
        "X:1 Y:1 Z:1 E:1 Count X:1 Y:1", "X:1 Y:1 Z:1 Count X:1 Y:1 Z:1",
        "X:1 Y:1 Z:1 E:1 Count X:1e30 Y:1 Z:1", "X:a Y:1 Z:1 E:1 Count X:1 Y:1 Z:1"}) {
    EXPECT_FALSE(position_in(other)) << other;
  }
}

TEST(command_file, is_read_forwards_and_backwards) {
  const TemporaryFolder folder;
  std::string text;
  for (int i = 1; i <= 500; ++i) text += "line " + std::to_string(i) + "\n";
  folder.write("commands", text);
  CommandFile file(folder.path() / "commands");
  for (const int i : {1, 2, 300, 299, 298, 500, 1, 450, 440, 386, 500}) {
    EXPECT_EQ(file.at(i), "line " + std::to_string(i));
  }
  EXPECT_THROW(file.at(501), std::runtime_error);
  EXPECT_EQ(file.at(500), "line 500");
}

TEST(command_file, gives_no_command_that_was_cut) {
  const TemporaryFolder folder;
  folder.write("commands", "G28\nG1 X5 F3000");
  CommandFile file(folder.path() / "commands");
  EXPECT_EQ(file.at(1), "G28");
  EXPECT_THROW(file.at(2), std::runtime_error);
  EXPECT_EQ(file.at(1), "G28");
  EXPECT_THROW(file.at(2), std::runtime_error);
}

TEST(journal, is_the_same_after_it_was_read_again) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "journal.json";
  Journal(path).write({.job = 5,
                       .file = "/a/b",
                       .commands = 9,
                       .base = 1 << 20,
                       .phase = Phase::paused,
                       .why = "because",
                       .outcome = Phase::failed,
                       .hotend_to_restore = 204.5});
  Journal again(path);
  ASSERT_TRUE(again.record());
  EXPECT_EQ(again.record()->job, 5);
  EXPECT_EQ(again.record()->file, "/a/b");
  EXPECT_EQ(again.record()->commands, 9);
  EXPECT_EQ(again.record()->base, 1 << 20);
  EXPECT_EQ(again.record()->phase, Phase::paused);
  EXPECT_EQ(again.record()->why, "because");
  EXPECT_EQ(again.record()->outcome, Phase::failed);
  EXPECT_EQ(again.record()->hotend_to_restore, 204.5);
  again.clear();
  EXPECT_FALSE(Journal(path).record());
}

TEST(journal, sets_aside_what_is_none_and_says_so) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "journal.json";
  EXPECT_EQ(Journal(path).damage(), "");
  folder.write("journal.json", "{\"job\": 5");
  EXPECT_NE(Journal(path).damage(), "");
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_EQ(files::text_of(path.string() + ".damaged"), "{\"job\": 5");
}

// The requirement: a full disk stops no record but the first.
TEST(journal, needs_no_more_space_after_the_first_record) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "journal.json";
  const auto files = [&] {
    std::set<std::pair<ino_t, blkcnt_t>> found;
    for (const auto& each : std::filesystem::directory_iterator(folder.path())) {
      struct stat status{};
      stat(each.path().c_str(), &status);
      found.emplace(status.st_ino, status.st_blocks);
    }
    return found;
  };
  Journal journal(path);
  Record record{.job = 5,
                .file = "/a",
                .commands = 9,
                .base = 1,
                .phase = Phase::running,
                .why = {},
                .outcome = Phase::cancelled};
  journal.write(record);
  const auto before = files();
  EXPECT_EQ(before.size(), 2u);
  for (const int length : {10, 4000, 0}) {
    record.why = std::string(static_cast<std::size_t>(length), 'x');
    journal.write(record);
    EXPECT_EQ(files(), before);
    EXPECT_EQ(Journal(path).record()->why, record.why);
  }
}

}  // namespace
