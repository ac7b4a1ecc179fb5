// SPDX-License-Identifier: Apache-2.0
// A print in co-simulation while uploads come without end: the edges of the same print without
// them, at the same distances, no underrun, the temperature, and pulses of 10 kHz to the clock.
#include <gmock/gmock.h>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <list>
#include <mutex>
#include <random>
#include <thread>

#include "tests/host/flood_measures.hpp"
#include "tests/host/raw_client.hpp"
#include "tests/host/repetitions.hpp"
#include "tests/host/spooled_print.hpp"
#include "tools/files/file_text.hpp"

namespace {

using namespace std::chrono_literals;
using host_test::Clock;
using host_test::json;
using host_test::number_of;
namespace fs = std::filesystem;

// The flood of the work that this one is compared with; in CI a short one.
constexpr double smallest_bytes = 50e3, largest_bytes = 150e6;
constexpr double shortest_pause_s = 0.1, longest_pause_s = 10;
const int flood_seconds = number_of("FLOOD_SECONDS", 12);
const auto seed = static_cast<unsigned>(number_of("FLOOD_SEED", 1));
// In steps of X: where all long lines have their speed, and beyond what homing reaches.
constexpr std::int64_t train_from = 20 * 80, train_to = 180 * 80, behind_homing = 10 * 80;
constexpr std::size_t most_kept = 4;  // uploads; older ones are removed, for the disk's sake

double log_uniform(double least, double most, std::mt19937& random) {
  return std::exp(std::uniform_real_distribution(std::log(least), std::log(most))(random));
}

std::chrono::duration<double> seconds(double count) { return std::chrono::duration<double>(count); }

// Lines that the check has work with.
std::string gcode_of(std::size_t bytes) {
  std::string text = "G28 X Y\n";
  text.reserve(bytes + 64);
  for (unsigned i = 0; text.size() < bytes; ++i) {
    text += "G1 X" + std::to_string(10 + i * 7 % 90) + " Y" + std::to_string(10 + i * 11 % 70) +
            " F6000\n";
  }
  return text;
}

// What is printed, in rounds of seven seconds: two lines of 125 mm/s at 80 steps/mm, and lines of
// 20 ms. Of these the printer holds about a second: a host that is late for longer is seen.
constexpr int round_s = 7;
std::string print_of(int length_s) {
  std::string text = "M104 S200\nM140 S60\nM190 S60\nM109 S200\nG28 X Y\nG90\nM82\nG92 E0\n";
  for (int i = 0; i < length_s / round_s + 1; ++i) {
    text += "G1 X190 F7500\nG1 X10 F7500\nG1 F3000\n";
    for (int j = 0; j < 200; ++j) {
      const int y = j < 100 ? 11 + j : 209 - j;
      text += "G1 Y" + std::to_string(y) + (j % 2 == 0 ? " X10\n" : " X10.1\n");
    }
  }
  return text + "G1 X0.5 Y0.5\nM84\n";
}

class Flood : public host_test::SpooledPrint {
 protected:
  Flood() : SpooledPrint("flood") {}
  ~Flood() override {
    if (spooler) kill_spooler();
    std::error_code ignored;
    fs::remove_all(folder / "data" / "files", ignored);  // a gigabyte
  }

  // The beginning of `text`, not to be printed; the number of its job, or 0.
  int upload_held(const std::string& text, std::size_t bytes) const {
    const std::string head =
        "--x\r\nContent-Disposition: form-data; name=\"print\"\r\n\r\nfalse\r\n--x\r\n"
        "Content-Disposition: form-data; name=\"file\"; filename=\"flood.gcode\"\r\n\r\n";
    const std::string tail = "\r\n--x--\r\n";
    const host_test::RawClient client(port());
    client.say(
        "POST /api/v1/jobs HTTP/1.1\r\nHost: localhost\r\nContent-Type: "
        "multipart/form-data; boundary=x\r\nContent-Length: " +
        std::to_string(head.size() + bytes + tail.size()) + "\r\n\r\n" + head);
    for (std::size_t at = 0; at < bytes; at += 1u << 20u) {
      client.say(text.substr(at, std::min(bytes - at, std::size_t{1} << 20u)));
    }
    client.say(tail);
    const std::string answer = client.all();
    if (!answer.contains(" 201 ")) return 0;
    return json::parse(answer.substr(answer.find("\r\n\r\n")), nullptr, false).value("id", 0);
  }
  void remove(int id) const {
    const std::string job = address + "/api/v1/jobs/" + std::to_string(id);
    curl({"--request", "POST", job + "/cancel"});
    curl({"--request", "DELETE", job});
  }

  // Uploads of other people until the first job is over: each at its time, whether or not
  // those before it are through.
  void flood_until_it_is_over() {
    const std::string text = gcode_of(static_cast<std::size_t>(largest_bytes));
    std::mt19937 random(seed);
    std::list<std::jthread> clients;
    auto next = Clock::now();
    const auto goes_on = [this] {
      const std::string now = job_state();
      return now.empty() || now == "printing";
    };
    while (goes_on()) {
      if (Clock::now() < next) {
        std::this_thread::sleep_for(50ms);
        continue;
      }
      next += std::chrono::duration_cast<Clock::duration>(
          seconds(log_uniform(shortest_pause_s, longest_pause_s, random)));
      const auto size =
          static_cast<std::size_t>(log_uniform(smallest_bytes, largest_bytes, random));
      ++begun;
      total_bytes += size;
      largest = std::max(largest, size);
      clients.emplace_back([&, size] {
        const int id = upload_held(text, size);
        const std::scoped_lock lock(mutex_);
        if (id > 0) ids_.push_back(id);
        acknowledged += id > 0 ? 1 : 0;
        if (ids_.size() <= most_kept) return;
        remove(ids_.front());
        ids_.pop_front();
      });
    }
  }

  int begun = 0;
  std::atomic<int> acknowledged = 0;
  std::size_t total_bytes = 0, largest = 0;

 private:
  std::mutex mutex_;
  std::list<int> ids_;
};

void expect_temperature_held(const json& report, const char* heater, double alone) {
  const double band = report.at(heater).at("band_c");
  std::printf("%s: within %.2f C of its target, without the flood %.2f C\n", heater, band, alone);
  EXPECT_GT(band, 0) << heater << " was not held";
  EXPECT_LE(band, 1) << heater;
}

void expect_exact_pulses(const host_test::Trains& trains, const host_test::Trains& alone) {
  std::printf(
      "trains of 10 kHz: %zu of %zu pulses, %lld to %lld clocks of 400 apart: %.3f Hz; "
      "without the flood %zu of %zu pulses\n",
      trains.count, trains.intervals, static_cast<long long>(trains.least),
      static_cast<long long>(trains.most), trains.hertz(), alone.count, alone.intervals);
  EXPECT_GE(trains.count, static_cast<std::size_t>(flood_seconds / round_s * 2));
  EXPECT_EQ(trains.count, alone.count);
  EXPECT_EQ(trains.intervals, alone.intervals);
  EXPECT_EQ(trains.least, host_test::train_interval);
  EXPECT_EQ(trains.most, host_test::train_interval);
}

TEST_F(Flood, bends_no_pulse_of_a_print) {
  const std::string text = print_of(flood_seconds);
  begin_chip("real", {"--warm"});
  begin_spooler("chip=" + (folder / "port").string());
  ASSERT_EQ(upload(text), "201");
  clear_bed("chip");
  expect_soon([&] { return done() > 8; }, "it does not print");
  const auto begin = Clock::now();
  flood_until_it_is_over();
  const std::chrono::duration<double> lasted = Clock::now() - begin;
  EXPECT_EQ(job_state(), "finished");
  std::printf("%d uploads in %.0f s, %d acknowledged; %.0f MB, the largest of %.1f MB\n", begun,
              lasted.count(), acknowledged.load(), static_cast<double>(total_bytes) / 1e6,
              static_cast<double>(largest) / 1e6);
  EXPECT_GE(begun, flood_seconds / 10);
  EXPECT_EQ(acknowledged, begun);
  EXPECT_GE(lasted.count(), flood_seconds * 0.9);

  expect_edges_of_print(text, {"--warm"});
  const json report = json::parse(files::text_of(folder / "report" / "report.json"));
  const json alone = json::parse(files::text_of(folder / "alone" / "report.json"));
  EXPECT_EQ(report.at("queue").at("underruns"), 0);
  const auto edges = host_test::edges_of(folder / "edges");
  const auto edges_alone = host_test::edges_of(folder / "alone.edges");
  const std::size_t moved = host_test::other_intervals(edges, edges_alone, behind_homing);
  std::printf(
      "%zu step edges, %zu at another distance from the one before than without; underruns: %d\n",
      edges.size(), moved, report.at("queue").at("underruns").get<int>());
  EXPECT_EQ(moved, 0u);
  for (const char* heater : {"hotend", "bed"}) {
    expect_temperature_held(report, heater, alone.at(heater).at("band_c"));
  }
  expect_exact_pulses(host_test::trains_of(edges, train_from, train_to),
                      host_test::trains_of(edges_alone, train_from, train_to));
}

}  // namespace
