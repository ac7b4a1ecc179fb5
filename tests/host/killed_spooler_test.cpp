// SPDX-License-Identifier: Apache-2.0
// Spooler and feeder are killed, or their machine loses power, at random instants while jobs come
// and are printed one after the other: each acknowledged job is printed once, line by line.
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <ios>
#include <map>
#include <optional>
#include <random>
#include <sstream>
#include <thread>

#include "directories.hpp"
#include "host/queue/queue.hpp"
#include "tests/host/power_loss/recording.hpp"
#include "tests/host/pty_printer.hpp"
#include "tests/host/repetitions.hpp"
#include "tests/temporary_folder.hpp"
#include "tools/files/file_text.hpp"
#include "tools/process/process.hpp"

namespace {

using namespace std::chrono_literals;
using host_test::number_of;

const int kills = number_of("SPOOLER_KILLS", 60), losses = number_of("SPOOLER_POWER_LOSSES", 20);
const auto seed = static_cast<unsigned>(number_of("KILL_SEED", 4));

// All that runs with this folder, also what no note names yet.
std::vector<pid_t> processes_with(const std::filesystem::path& folder) {
  std::vector<pid_t> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename().string();
    const pid_t id = std::atoi(name.c_str());
    if (id <= 0 || id == getpid()) continue;
    try {
      if (files::text_of(entry.path() / "cmdline").contains(folder.string())) found.push_back(id);
    } catch (const std::ios_base::failure&) {  // it has just ended
    }
  }
  return found;
}

class KilledSpooler : public testing::Test {
 protected:
  ~KilledSpooler() override { kill_all(); }

  process::Identity feeder() const {
    process::Identity identity;
    std::ifstream(data() / "printers/printer/feeder.process") >> identity.id >> identity.started;
    return identity;
  }
  std::filesystem::path data() const {
    return (recording ? recording->folder() : folder.path()) / "data";
  }
  void kill_all() const {
    for (auto left = processes_with(data()); !left.empty(); left = processes_with(data())) {
      for (const pid_t id : left) kill(id, SIGKILL);
      std::this_thread::sleep_for(1ms);
    }
  }
  process::Start worker(const std::vector<std::string>& more) const {
    std::vector<std::string> words{BUILD_DIRECTORY "/bin/spooler_worker", data().string(),
                                   (folder.path() / "port").string()};
    words.insert(words.end(), more.begin(), more.end());
    return {.arguments = words, .to_pipe = true, .has_input = false};
  }
  // Its jobs begin with this number. It ends by `end` some time after it has begun to work.
  void work(int first, std::chrono::milliseconds time, const std::function<void()>& end) {
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
    ASSERT_FALSE(process.ending()) << "it ended by itself";
    end();
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

  // Without kills until all jobs are over.
  void expect_all_printed(int rounds) {
    const auto last = process::capture(worker({std::to_string(100 * rounds), "1"}));
    ASSERT_EQ(last.exit_status, 0) << last.output;
    EXPECT_GE(acknowledged.size(), static_cast<std::size_t>(rounds / 2));
    std::map<std::string, int> executed;
    for (const std::string& line : printer.executed()) ++executed[line];
    queue::Queue jobs(data() / "queue.db");
    for (const auto& [id, number] : acknowledged) {
      const auto job = jobs.find(id);
      ASSERT_TRUE(job) << "job " << id << " is lost";
      EXPECT_EQ(job->state, queue::JobState::finished) << "job " << id << ": " << job->reason;
      EXPECT_EQ(job->starts, 1) << "job " << id;
    }
    for (const queue::Job& job : jobs.jobs(1'000'000)) {
      const std::string number = job.name.substr(0, job.name.find('.'));
      for (int line = 0; line < 5; ++line) {
        const std::string text = "M117 job " + number + " line " + std::to_string(line);
        EXPECT_EQ(executed[text], 1) << text;
      }
    }
    std::printf("%d times, %zu jobs acknowledged and printed\n", rounds, acknowledged.size());
  }

  TemporaryFolder folder;
  std::optional<power_loss::Recording> recording;
  host_test::PtyPrinter printer{folder.path() / "port"};
  std::map<queue::JobId, int> acknowledged;  // with the number of their text
};

TEST_F(KilledSpooler, prints_each_acknowledged_job_once) {
  std::mt19937 random(seed);
  for (int i = 0; i < kills; ++i) {
    const std::chrono::milliseconds time(random() % 700);
    const bool kills_feeder = random() % 4 == 0;
    work(100 * i, time, [&] {
      if (kills_feeder) process::signal(feeder(), SIGKILL);
    });
    if (HasFatalFailure()) return;
  }
  expect_all_printed(kills);
}

// Of the spooler's machine: the printer has its own supply, and knows what it was sent.
TEST_F(KilledSpooler, prints_each_acknowledged_job_once_although_power_is_lost) {
  std::mt19937 random(seed);
  recording.emplace(folder.path());
  for (int i = 0; i < losses; ++i) {
    recording->begin();
    work(100 * i, std::chrono::milliseconds(random() % 700), [&] { kill_all(); });
    if (HasFatalFailure()) return;
    const auto records = recording->end();
    recording->cut(records, records.size(), random);
  }
  expect_all_printed(losses);
}

}  // namespace
