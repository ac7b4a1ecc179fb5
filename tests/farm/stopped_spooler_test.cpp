// SPDX-License-Identifier: Apache-2.0
// A spooler that stands still beyond its lease, as on a machine that sleeps: when it goes on, it
// starts and writes nothing for a printer that another one has by then.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <pqxx/pqxx>
#include <random>
#include <thread>

#include "tests/farm/farm_queue.hpp"
#include "tests/farm/postgres_server.hpp"
#include "tests/farm/worker_process.hpp"
#include "tests/host/repetitions.hpp"

namespace {

using namespace std::chrono_literals;
using namespace queue;

const int stops = host_test::number_of("FARM_STOPS", 3);
constexpr auto lease_time = 800ms;

class StoppedSpooler : public testing::Test {
 protected:
  template <class Condition>
  void expect_soon(const Condition& fits, const char* what) {
    const auto end = std::chrono::steady_clock::now() + 60s;
    while (!fits()) {
      ASSERT_LT(std::chrono::steady_clock::now(), end) << what;
      std::this_thread::sleep_for(5ms);
    }
  }
  // Changes of jobs that the printer has, or gets.
  std::int64_t changes_of_prints() const {
    pqxx::connection client(address);
    return pqxx::nontransaction(client)
        .exec(
            "SELECT count(*) FROM changes WHERE to_state IN ('starting', 'printing', 'finished') "
            "OR from_state IN ('starting', 'printing')")[0][0]
        .as<std::int64_t>();
  }

  TemporaryFolder folder;
  std::string address = farm_test::shared_server().new_database();
};

TEST_F(StoppedSpooler, starts_and_writes_nothing_after_another_one_has_its_printer) {
  std::mt19937 random(3);
  for (int i = 0; i < stops; ++i) {
    farm_test::WorkerProcess worker(folder.path() / std::to_string(i), address, "left",
                                    static_cast<unsigned>(random()), lease_time);
    expect_soon([&] { return worker.said().contains("sent "); }, "it does not work");
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % 200));
    worker.signal(SIGSTOP);
    Queue other = farm_test::open_farm(address, "other", lease_time);
    // Also where it was stopped in a transaction, the server ends that.
    const auto claims = [&] {
      try {
        return other.claim("left").empty();
      } catch (const Unavailable&) {
        return false;
      }
    };
    expect_soon(claims, "its lease does not end");
    const std::size_t said = worker.said().size();
    const std::int64_t changes = changes_of_prints();
    worker.signal(SIGCONT);
    for (int j = 0; j < 8; ++j) {
      std::this_thread::sleep_for(100ms);
      other.renew();
    }
    const std::string after = worker.said().substr(said);
    EXPECT_FALSE(after.contains("sent ")) << after;
    EXPECT_FALSE(after.contains("claimed ")) << after;
    EXPECT_EQ(changes_of_prints(), changes);
    EXPECT_TRUE(other.holds("left"));
    EXPECT_TRUE(other.active_on("left") == std::nullopt);
    // It takes its printer again when the other one has given it back.
    other.release();
    expect_soon([&] { return worker.said().substr(said).contains("sent "); }, "it does not go on");
  }
}

}  // namespace
