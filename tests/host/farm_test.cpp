// SPDX-License-Identifier: Apache-2.0
// Four simulated printers behind one spooler print the jobs of four users in the order of the
// queue: each start takes the first job that its printer can take.
#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "tests/host/repetitions.hpp"
#include "tests/host/spooled_print.hpp"

namespace {

using host_test::moves;
using host_test::number_of;
using host_test::SpooledPrint;
using nlohmann::json;

// In CI a sample.
const int jobs = number_of("FARM_JOBS", 8);

struct Waiting {
  int id{};
  std::string printer;  // wanted; empty: any
};

TEST_F(SpooledPrint, four_printers_print_the_jobs_of_four_users_in_the_order_of_the_queue) {
  begin_spooler("simulated:4");
  std::vector<std::string> printers;
  expect_soon([&] { return state().at("printers").size() == 4; }, "no printers");
  for (const json& each : state().at("printers")) printers.push_back(each.at("name"));
  std::mt19937 random(static_cast<unsigned>(number_of("FARM_SEED", 1)));
  for (int i = 0; i < jobs; ++i) {
    const std::string wanted = random() % 4 == 0 ? printers[random() % 4] : "";
    const std::string name =
        "user" + std::to_string(i % 4) + "_" + std::to_string(i / 4) + ".gcode";
    ASSERT_EQ(upload(moves(5 + static_cast<int>(random() % 30)), name, wanted), "201");
  }
  for (int i = 0; i < jobs / 4; ++i) {  // a person changes the order
    const auto one = 1 + random() % static_cast<unsigned>(jobs);
    const auto other = 1 + random() % static_cast<unsigned>(jobs);
    curl({"--data", "{\"before\":" + std::to_string(other) + "}",
          address + "/api/v1/jobs/" + std::to_string(one) + "/move"});
  }
  std::vector<Waiting> order;
  expect_soon(
      [&] {
        order.clear();
        const json all = state();
        for (const json& each : all.at("jobs")) {
          if (each.at("state") == "queued") {
            order.push_back({each.at("id"), each.at("wanted_printer")});
          }
        }
        return order.size() == static_cast<std::size_t>(jobs);
      },
      "not all jobs are checked");

  std::map<int, json> over;
  expect_soon(
      [&] {
        const json all = state();
        for (const json& each : all.at("printers")) {
          if (each.at("job").is_null() && !each.at("bed_clear")) clear_bed(each.at("name"));
        }
        for (const json& each : all.at("jobs")) {
          if (each.at("state") == "finished") over[each.at("id")] = each;
        }
        return over.size() == static_cast<std::size_t>(jobs);
      },
      "not all jobs are finished");

  // By the times in their histories: each start took the first job that its printer could take.
  std::vector<std::pair<std::int64_t, int>> starts;
  for (const auto& [id, job] : over) {
    EXPECT_EQ(job.at("starts"), 1) << "job " << id;
    const json whole =
        json::parse(curl({address + "/api/v1/jobs/" + std::to_string(id)}), nullptr, false);
    for (const json& change : whole.at("history")) {
      if (change.at("to") == "starting") starts.emplace_back(change.at("time_ms"), id);
    }
  }
  // Starts within a millisecond were made in the order of the queue.
  const auto place = [&](int id) { return std::ranges::find(order, id, &Waiting::id); };
  std::ranges::sort(starts, [&](const auto& one, const auto& other) {
    return one.first != other.first ? one.first < other.first
                                    : place(one.second) < place(other.second);
  });
  ASSERT_EQ(starts.size(), static_cast<std::size_t>(jobs));
  std::set<std::string> used;
  for (const auto& [time, id] : starts) {
    const std::string printer = over.at(id).at("printer");
    used.insert(printer);
    const auto first = std::ranges::find_if(order, [&](const Waiting& each) {
      return each.printer.empty() || each.printer == printer;
    });
    ASSERT_NE(first, order.end());
    EXPECT_EQ(first->id, id) << "on " << printer;
    order.erase(place(id));
  }
  EXPECT_EQ(used.size(), 4u);
}

}  // namespace
