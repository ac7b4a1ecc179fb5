// SPDX-License-Identifier: Apache-2.0
// A process that works with the queue is killed at random instants: no acknowledged job is lost,
// and none is started twice.
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <random>
#include <sstream>
#include <thread>

#include "directories.hpp"
#include "host/queue/queue.hpp"
#include "host/queue/store.hpp"
#include "tests/temporary_folder.hpp"
#include "tools/process/process.hpp"

namespace {

constexpr int kills = 200;

struct Acknowledged {
  std::map<queue::JobId, std::int64_t> added;  // with their bytes
  std::map<queue::JobId, int> sent;
};

// What the worker has said before it was killed. An incomplete last line was not said.
void read_lines(const std::string& text, Acknowledged& acknowledged) {
  std::istringstream lines(text.substr(0, text.rfind('\n') + 1));
  std::string word;
  queue::JobId id = 0;
  while (lines >> word >> id) {
    if (word == "added") lines >> acknowledged.added[id];
    if (word == "sent") ++acknowledged.sent[id];
  }
}

std::string read_for(int descriptor, std::chrono::microseconds time, process::Process& worker) {
  std::string text;
  std::array<char, 4096> buffer{};
  // Opening the queue is no work: the time begins with the first line.
  ssize_t count = read(descriptor, buffer.data(), buffer.size());
  if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
  std::this_thread::sleep_for(time);
  EXPECT_FALSE(worker.ending()) << "it ended before it was killed";
  worker.signal(SIGKILL);
  while ((count = read(descriptor, buffer.data(), buffer.size())) > 0) {
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
  return text;
}

void expect_nothing_lost(const std::filesystem::path& folder, const Acknowledged& acknowledged) {
  queue::Queue jobs(folder / "queue.db");
  const queue::Store store(folder / "files");
  for (const auto& [id, bytes] : acknowledged.added) {
    const auto job = jobs.find(id);
    ASSERT_TRUE(job) << "job " << id << " is lost";
    ASSERT_EQ(job->bytes, bytes);
    ASSERT_EQ(std::filesystem::file_size(store.path_of(job->file)), bytes) << "of job " << id;
  }
  for (const auto& [id, times] : acknowledged.sent) {
    ASSERT_EQ(times, 1) << "job " << id << " was sent twice";
    const auto job = jobs.find(id);
    ASSERT_TRUE(job);
    ASSERT_TRUE(job->state == queue::JobState::finished || is_active(job->state) ||
                job->state == queue::JobState::interrupted)
        << "job " << id << " was sent and is " << name_of(job->state);
    const auto history = jobs.history(id);
    ASSERT_EQ(std::ranges::count(history, queue::JobState::starting, &queue::Change::to), 1);
  }
}

TEST(killed_queue, loses_no_acknowledged_job_and_starts_none_twice) {
  const TemporaryFolder folder;
  std::mt19937 random(20);
  Acknowledged acknowledged;
  for (int i = 0; i < kills; ++i) {
    process::Process worker({.arguments = {BUILD_DIRECTORY "/bin/queue_worker",
                                           folder.path().string(), std::to_string(i)},
                             .to_pipe = true,
                             .has_input = false});
    const std::chrono::microseconds time(random() % 30'000);
    read_lines(read_for(worker.pipe(), time, worker), acknowledged);
    ASSERT_EQ(worker.wait().exit_status, 128 + SIGKILL);
    expect_nothing_lost(folder.path(), acknowledged);
    if (HasFatalFailure()) return;
  }
  EXPECT_GE(acknowledged.added.size(), std::size_t{kills});
  EXPECT_GE(acknowledged.sent.size(), std::size_t{kills / 10});
}

}  // namespace
