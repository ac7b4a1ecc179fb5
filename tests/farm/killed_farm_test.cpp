// SPDX-License-Identifier: Apache-2.0
// Several spoolers on one queue, and the server, are killed at random instants: no acknowledged job
// is lost, none is begun twice, and the order is kept.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <map>
#include <random>
#include <set>
#include <thread>
#include <vector>

#include "host/queue/shared_files.hpp"
#include "tests/farm/farm_queue.hpp"
#include "tests/farm/postgres_server.hpp"
#include "tests/farm/worker_process.hpp"
#include "tests/host/known_text.hpp"
#include "tests/host/repetitions.hpp"
#include "tools/files/file_text.hpp"

namespace {

using namespace queue;
using farm_test::WorkerProcess;
using host_test::number_of;

const int kills = number_of("FARM_KILLS", 24), server_kills = number_of("FARM_SERVER_KILLS", 3);
const auto seed = static_cast<unsigned>(number_of("KILL_SEED", 7));
constexpr int workers = 3;

class KilledFarm : public testing::Test {
 protected:
  void begin(std::size_t which) {
    auto& worker = running[which];
    const std::string name = "printer-" + std::to_string(which);
    worker = std::make_unique<WorkerProcess>(folder.path() / name, address, name,
                                             static_cast<unsigned>(random()),
                                             std::chrono::milliseconds(2000));
  }
  void begin_all() {
    for (std::size_t i = 0; i < workers; ++i) begin(i);
  }
  void expect_lines(std::size_t which, std::size_t lines) {
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (running[which]->lines() < lines) {
      ASSERT_LT(std::chrono::steady_clock::now(), limit) << running[which]->said();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  void end(std::size_t which) {
    const std::string said = running[which]->kill();
    const std::string whole = said.substr(0, said.rfind('\n') + 1);
    std::istringstream lines(whole);
    std::string word;
    JobId id = 0;
    while (lines >> word >> id) {
      if (word == "added") lines >> added[id];
      if (word == "sent") ++sent[id];
    }
  }

  void expect_all_kept() {
    Queue jobs = farm_test::open_farm(address, "watcher");
    const Store store(folder.path() / "fetched");
    for (const auto& [id, bytes] : added) {
      const auto job = jobs.find(id);
      ASSERT_TRUE(job) << "job " << id << " is lost";
      EXPECT_EQ(job->bytes, bytes);
      SharedFiles(address).fetch(job->file, store);
      const std::string text = files::text_of(store.path_of(job->file));
      EXPECT_TRUE(host_test::is_known_text(text) && text.size() == static_cast<std::size_t>(bytes));
    }
    for (const auto& [id, times] : sent) {
      EXPECT_EQ(times, 1) << "job " << id << " was begun twice";
      const JobState state = jobs.find(id).value().state;
      EXPECT_TRUE(state == JobState::finished || state == JobState::interrupted || is_active(state))
          << "job " << id << " was begun and is " << name_of(state);
    }
    std::set<std::string> files;
    for (const Job& job : jobs.jobs(1'000'000)) {
      EXPECT_TRUE(files.insert(job.file).second) << "an upload became two jobs";
    }
    expect_order(jobs);
  }

  // Whenever one was started, it was the first of those that waited.
  void expect_order(Queue& jobs) {
    pqxx::connection client(address);
    pqxx::nontransaction work(client);
    std::set<JobId> waiting;
    for (const auto& [job, to] :
         work.exec("SELECT job, to_state FROM changes ORDER BY rowid").iter<JobId, std::string>()) {
      if (to == "starting") {
        EXPECT_EQ(job, *waiting.begin()) << "it was not its turn";
      }
      waiting.erase(job);
      if (to == "queued") waiting.insert(job);
    }
    EXPECT_FALSE(jobs.jobs(1).empty());
  }

  TemporaryFolder folder;
  farm_test::PostgresServer server;
  std::string address = server.new_database();
  std::mt19937 random{seed};
  std::map<std::size_t, std::unique_ptr<WorkerProcess>> running;
  std::map<JobId, std::int64_t> added;  // acknowledged, with their bytes
  std::map<JobId, int> sent;
};

TEST_F(KilledFarm, loses_no_job_and_begins_none_twice_when_spoolers_are_killed) {
  begin_all();
  for (int i = 0; i < kills; ++i) {
    const std::size_t which = random() % workers;
    expect_lines(which, running[which]->lines() + 1 + random() % 6);
    if (HasFatalFailure()) return;
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 5000));
    end(which);
    begin(which);
  }
  for (std::size_t i = 0; i < workers; ++i) end(i);
  expect_all_kept();
  std::printf("%d kills, %zu jobs acknowledged, %zu begun\n", kills, added.size(), sent.size());
  EXPECT_GE(added.size(), static_cast<std::size_t>(kills / 2));
  EXPECT_GE(sent.size(), static_cast<std::size_t>(kills / 8));
}

TEST_F(KilledFarm, loses_no_job_and_begins_none_twice_when_the_server_is_killed) {
  begin_all();
  for (int i = 0; i < server_kills; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(300 + random() % 500));
    server.stop(random() % 2 == 0 ? SIGQUIT : SIGKILL);
    server.start();
    // They connect again by themselves.
    expect_lines(0, running[0]->lines() + 1);
    if (HasFatalFailure()) return;
  }
  for (std::size_t i = 0; i < workers; ++i) end(i);
  expect_all_kept();
  std::printf("%d kills of the server, %zu jobs acknowledged, %zu begun\n", server_kills,
              added.size(), sent.size());
  EXPECT_GE(sent.size(), static_cast<std::size_t>(server_kills));
}

}  // namespace
