// SPDX-License-Identifier: Apache-2.0
// Four simulated printers behind one spooler print the jobs of four users in the order of the
// queue: each start takes the first job that its printer may take.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <random>
#include <set>

#include "tests/host/repetitions.hpp"
#include "tests/host/spooled_print.hpp"

namespace {

using host_test::Clock;
using host_test::job;
using host_test::json;
using host_test::number_of;

const int jobs_of_each = number_of("PRINTER_JOBS", 20) / 4;
const int jobs = jobs_of_each * 4;
const auto seed = static_cast<unsigned>(number_of("PRINTER_JOBS_SEED", 1));

struct Waiting {
  int id{};
  std::string printer;  // wanted; empty: any
};

struct JobStart {
  std::int64_t time_ms{};
  int id{};
  std::string printer;
};

class Farm : public host_test::SpooledPrint {
 protected:
  Farm() : SpooledPrint("farm") {
    begin_spooler("simulated:4");
    const json all = state();
    for (const json& each : all.at("printers")) printers.push_back(each.at("name"));
  }

  // Each user uploads one file after the other, some of them for one printer.
  void upload_as_four_users() {
    std::vector<std::jthread> users;
    for (int user = 0; user < 4; ++user) {
      users.emplace_back([this, user] {
        std::mt19937 random(seed * 4 + static_cast<unsigned>(user));
        for (int i = 0; i < jobs_of_each; ++i) {
          const std::string printer = random() % 4 == 0 ? printers[random() % 4] : "";
          EXPECT_EQ(
              upload(job(5 + static_cast<int>(random() % 30)),
                     "user" + std::to_string(user) + "_" + std::to_string(i) + ".gcode", printer),
              "201");
        }
      });
    }
  }
  void change_the_order() {
    std::mt19937 random(seed);
    const auto any_job = [&] { return std::to_string(1 + random() % static_cast<unsigned>(jobs)); };
    for (int i = 0; i < jobs / 4; ++i) {
      const std::string body = "{\"before\":" + any_job() + "}";
      curl({"--data", body, address + "/api/v1/jobs/" + any_job() + "/move"});
    }
  }
  // Those that may start, as the queue says it.
  std::vector<Waiting> queue() {
    std::vector<Waiting> order;
    const json all = state();
    for (const json& each : all.at("jobs")) {
      if (each.at("state") == "queued") order.push_back({each.at("id"), each.at("wanted_printer")});
    }
    return order;
  }
  // As people who take the finished parts away.
  void clear_beds_until_all_are_printed() {
    expect_soon(
        [&] {
          const json all = state();
          for (const json& each : all.at("printers")) {
            if (each.at("job").is_null() && !each.at("bed_clear")) clear_bed(each.at("name"));
          }
          return std::ranges::count(all.at("jobs"), "finished", [](const json& each) {
                   return each.at("state").get<std::string>();
                 }) == jobs;
        },
        "not all jobs are finished");
  }
  // All starts by the histories of the jobs, in their order; within a millisecond in that of the
  // queue, which is the same.
  std::vector<JobStart> starts(const std::vector<Waiting>& order) {
    std::vector<JobStart> all;
    for (const Waiting& each : order) {
      const json whole = json::parse(curl({address + "/api/v1/jobs/" + std::to_string(each.id)}));
      for (const json& change : whole.at("history")) {
        if (change.at("to") != "starting") continue;
        all.push_back({change.at("time_ms"), each.id, whole.at("printer")});
      }
    }
    std::ranges::stable_sort(all, {}, &JobStart::time_ms);
    return all;
  }

  std::vector<std::string> printers;
};

TEST_F(Farm, prints_the_jobs_of_four_users_in_the_order_of_the_queue) {
  ASSERT_EQ(printers.size(), 4u);
  upload_as_four_users();
  change_the_order();
  expect_soon([&] { return queue().size() == static_cast<std::size_t>(jobs); },
              "not all jobs are checked");
  std::vector<Waiting> order = queue();
  const auto begin = Clock::now();
  clear_beds_until_all_are_printed();
  const std::chrono::duration<double> lasted = Clock::now() - begin;

  const std::vector<JobStart> all = starts(order);
  ASSERT_EQ(all.size(), static_cast<std::size_t>(jobs)) << "each job starts once";
  std::map<std::string, int> prints;
  for (const JobStart& start : all) {
    ++prints[start.printer];
    const auto first = std::ranges::find_if(order, [&](const Waiting& each) {
      return each.printer.empty() || each.printer == start.printer;
    });
    ASSERT_NE(first, order.end());
    EXPECT_EQ(first->id, start.id) << "on " << start.printer;
    std::erase_if(order, [&](const Waiting& each) { return each.id == start.id; });
  }
  std::printf("%d jobs of 4 users in %.0f s:", jobs, lasted.count());
  for (const auto& [printer, count] : prints) std::printf(" %s %d", printer.c_str(), count);
  std::printf("\n");
  EXPECT_EQ(prints.size(), 4u) << "a printer has had nothing to do";
}

}  // namespace
