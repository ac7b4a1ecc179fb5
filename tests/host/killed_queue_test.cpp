// SPDX-License-Identifier: Apache-2.0
// A process that works with the queue is killed, or loses power, at random instants: no
// acknowledged job is lost, and none is started twice.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <random>
#include <thread>

#include "directories.hpp"
#include "tests/host/acknowledged.hpp"
#include "tests/host/power_loss/recording.hpp"
#include "tests/host/repetitions.hpp"
#include "tests/temporary_folder.hpp"
#include "tools/process/process.hpp"

namespace {

using host_test::Acknowledged;
using host_test::number_of;

const int kills = number_of("QUEUE_KILLS", 200), losses = number_of("POWER_LOSSES", 100);
const auto seed = static_cast<unsigned>(number_of("KILL_SEED", 20));

// What the worker says until it is killed, so long after so many lines.
std::string work(const std::filesystem::path& folder, std::mt19937& random) {
  process::Process worker({.arguments = {BUILD_DIRECTORY "/bin/queue_worker", folder.string(),
                                         std::to_string(random())},
                           .to_pipe = true,
                           .has_input = false});
  const auto lines = static_cast<std::ptrdiff_t>(1 + random() % 6);
  const std::chrono::microseconds time(random() % 5000);
  std::string text;
  std::array<char, 4096> buffer{};
  ssize_t count = 1;
  const auto read_some = [&] {
    count = read(worker.pipe(), buffer.data(), buffer.size());
    if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
    return count > 0;
  };
  while (std::ranges::count(text, '\n') < lines && read_some()) {
  }
  EXPECT_GT(count, 0) << "it ended before it was killed: " << text;
  std::this_thread::sleep_for(time);
  worker.signal(SIGKILL);
  while (read_some()) {
  }
  EXPECT_EQ(worker.wait().exit_status, 128 + SIGKILL) << text;
  return text;
}

// The folder and what is known of it, new ones now and then.
template <class Place>
class Places {
 public:
  template <class... Arguments>
  Place& next(const Arguments&... arguments) {
    constexpr int uses = 50;
    if (uses_++ % uses == 0) place_.emplace(arguments...);
    return *place_;
  }

 private:
  std::optional<Place> place_;
  int uses_ = 0;
};

struct Killed {
  TemporaryFolder folder;
  Acknowledged acknowledged;
};

TEST(killed_queue, loses_no_acknowledged_job_and_starts_none_twice) {
  std::mt19937 random(seed);
  Places<Killed> places;
  std::size_t added = 0, sent = 0;
  for (int i = 0; i < kills; ++i) {
    auto& [folder, acknowledged] = places.next();
    const std::size_t added_before = acknowledged.added(), sent_before = acknowledged.sent();
    acknowledged.hear(work(folder.path(), random));
    ASSERT_EQ(acknowledged.violation(folder.path()), "") << "after kill " << i;
    if (HasFailure()) return;
    added += acknowledged.added() - added_before;
    sent += acknowledged.sent() - sent_before;
  }
  std::printf("%d kills, %zu jobs acknowledged, %zu sent\n", kills, added, sent);
  EXPECT_GE(added, static_cast<std::size_t>(kills));
  EXPECT_GE(sent, static_cast<std::size_t>(kills / 10));
}

// One disk over many losses of power.
class Powerless {
 public:
  explicit Powerless(const std::string& fault) : recording_(folder_.path(), fault) {}

  // Works, loses power after a random operation, and looks. Returns what is violated.
  std::string lose(std::mt19937& random) {
    recording_.begin();
    work(recording_.folder(), random);
    const auto records = recording_.end();
    const std::size_t operations = power_loss::random_cut(records, random);
    acknowledged.hear(recording_.cut(records, operations, random));
    // In a copy: who looks writes too, and is not recorded.
    const std::filesystem::path copy = folder_.path() / "copy";
    std::filesystem::remove_all(copy);
    std::filesystem::copy(recording_.folder(), copy, std::filesystem::copy_options::recursive);
    return acknowledged.violation(copy);
  }
  Acknowledged acknowledged;

 private:
  TemporaryFolder folder_;
  power_loss::Recording recording_;
};

TEST(powerless_queue, loses_no_acknowledged_job_and_starts_none_twice) {
  std::mt19937 random(seed);
  Places<Powerless> places;
  std::size_t added = 0, sent = 0;
  for (int i = 0; i < losses; ++i) {
    Powerless& disk = places.next("");
    const std::size_t added_before = disk.acknowledged.added();
    const std::size_t sent_before = disk.acknowledged.sent();
    ASSERT_EQ(disk.lose(random), "") << "after loss " << i;
    if (HasFailure()) return;
    added += disk.acknowledged.added() - added_before;
    sent += disk.acknowledged.sent() - sent_before;
  }
  std::printf("%d losses of power, %zu jobs acknowledged, %zu sent\n", losses, added, sent);
  EXPECT_GE(added, static_cast<std::size_t>(losses / 2));
  EXPECT_GE(sent, static_cast<std::size_t>(losses / 20));
}

// What the test is for: each of these is found.
class FaultyQueue : public testing::TestWithParam<const char*> {};

TEST_P(FaultyQueue, is_found) {
  constexpr int patience = 400;
  std::mt19937 random(seed);
  std::string found;
  int losses_until_found = 0;
  while (found.empty() && losses_until_found < patience) {
    Powerless disk(GetParam());
    for (int i = 0; i < 20 && found.empty() && !HasFailure(); ++i) {
      found = disk.lose(random);
      ++losses_until_found;
    }
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_NE(found, "") << "not found in " << losses_until_found << " losses";
  std::printf("found after %d losses: %s\n", losses_until_found, found.c_str());
}

INSTANTIATE_TEST_SUITE_P(of_synchronisation, FaultyQueue,
                         testing::Values("no_file_sync", "no_folder_sync", "no_database_sync",
                                         "rename_first"),
                         [](const auto& each) { return std::string(each.param); });

}  // namespace
