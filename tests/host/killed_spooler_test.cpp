// SPDX-License-Identifier: Apache-2.0
// Spooler and feeder are killed at random instants while jobs come and are printed one after the
// other: each acknowledged job is printed once, line by line.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <thread>

#include "directories.hpp"
#include "host/queue/queue.hpp"
#include "tests/host/pty_printer.hpp"
#include "tests/temporary_folder.hpp"
#include "tools/process/process.hpp"

namespace {

using namespace std::chrono_literals;
constexpr int kills = 60;

class KilledSpooler : public testing::Test {
 protected:
  ~KilledSpooler() override { process::signal(feeder(), SIGKILL); }

  process::Identity feeder() const {
    process::Identity identity;
    std::ifstream(data() / "printers/printer/feeder.process") >> identity.id >> identity.started;
    return identity;
  }
  std::filesystem::path data() const { return folder.path() / "data"; }
  process::Start worker(const std::vector<std::string>& more) const {
    std::vector<std::string> words{BUILD_DIRECTORY "/bin/spooler_worker", data().string(),
                                   (folder.path() / "port").string()};
    words.insert(words.end(), more.begin(), more.end());
    return {.arguments = words, .to_pipe = true, .has_input = false};
  }
  // Its jobs begin with this number. It is killed some time after it has begun to work.
  void work_and_be_killed(int first, std::chrono::milliseconds time, bool kills_feeder) {
    process::Process process(worker({std::to_string(first)}));
    std::array<char, 4096> buffer{};
    std::string text;
    const auto read_some = [&] {
      const ssize_t count = read(process.pipe(), buffer.data(), buffer.size());
      if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
      return count > 0;
    };
    ASSERT_TRUE(read_some());
    std::this_thread::sleep_for(time);
    if (kills_feeder) process::signal(feeder(), SIGKILL);
    ASSERT_FALSE(process.ending()) << "it ended by itself";
    process.signal(SIGKILL);
    while (read_some()) {
    }
    process.wait();
    note(text);
  }
  // An incomplete last line was not said.
  void note(const std::string& text) {
    std::istringstream lines(text.substr(0, text.rfind('\n') + 1));
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string word;
      queue::JobId id = 0;
      int number = 0;
      if (words >> word >> id >> number && word == "added") acknowledged[id] = number;
    }
  }

  TemporaryFolder folder;
  host_test::PtyPrinter printer{folder.path() / "port"};
  std::map<queue::JobId, int> acknowledged;  // with the number of their text
};

TEST_F(KilledSpooler, prints_each_acknowledged_job_once) {
  std::mt19937 random(4);
  for (int i = 0; i < kills; ++i) {
    work_and_be_killed(100 * i, std::chrono::milliseconds(random() % 700), random() % 4 == 0);
    if (HasFatalFailure()) return;
  }
  const auto last = process::capture(worker({std::to_string(100 * kills), "1"}));
  ASSERT_EQ(last.exit_status, 0) << last.output;
  EXPECT_GE(acknowledged.size(), std::size_t{kills / 2});

  std::map<std::string, int> executed;
  for (const std::string& line : printer.executed()) ++executed[line];
  queue::Queue jobs(data() / "queue.db");
  for (const auto& [id, number] : acknowledged) {
    const auto job = jobs.find(id);
    ASSERT_TRUE(job) << "job " << id << " is lost";
    EXPECT_EQ(job->state, queue::JobState::finished) << "job " << id << ": " << job->reason;
    EXPECT_EQ(job->starts, 1) << "job " << id;
  }
  for (const queue::Job& job : jobs.jobs()) {
    const std::string number = job.name.substr(0, job.name.find('.'));
    for (int line = 0; line < 5; ++line) {
      const std::string text = "M117 job " + number + " line " + std::to_string(line);
      EXPECT_EQ(executed[text], 1) << text;
    }
  }
}

}  // namespace
