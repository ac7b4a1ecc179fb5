// SPDX-License-Identifier: Apache-2.0
// A print in co-simulation while uploads come without end: the same steps, no underrun, the
// temperature of a print alone, and pulses of 10 kHz exact to the clock.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <random>
#include <thread>

#include "tests/host/raw_client.hpp"
#include "tests/host/repetitions.hpp"
#include "tests/host/spooled_print.hpp"
#include "tools/files/file_text.hpp"

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using host_test::Edge;
using host_test::number_of;
using host_test::SpooledPrint;
using nlohmann::json;

constexpr double smallest_bytes = 50e3, shortest_pause_s = 0.1;
// In CI a short flood of small files.
const int flood_seconds = number_of("FLOOD_SECONDS", 8);
const double largest_bytes = 1e6 * number_of("FLOOD_LARGEST_MB", 10);
const double longest_pause_s = 0.1 * number_of("FLOOD_LONGEST_PAUSE", 20);  // tenths
const auto seed = static_cast<unsigned>(number_of("FLOOD_SEED", 1));

double log_uniform(double least, double most, std::mt19937& random) {
  std::uniform_real_distribution<double> exponent(std::log(least), std::log(most));
  return std::exp(exponent(random));
}

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

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

class Flood : public SpooledPrint {
 protected:
  // The beginning of `text`, held; the number of its job, or 0.
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
};

// Lines of 125 mm/s with 80 steps/mm, and short ones between them.
std::string print_of(int seconds) {
  std::string text = "M104 S200\nM140 S60\nM109 S200\nG28 X Y\nG90\nM82\nG92 E0\n";
  for (int i = 0; i < seconds / 4 + 1; ++i) {
    text += "G1 X190 F7500\nG1 X10 F7500\n";
    for (int j = 0; j < 10; ++j) {
      text += "G1 X" + std::to_string(12 + j % 3 * 4) + " Y" + std::to_string(5 + j) + " F6000\n";
    }
  }
  return text + "G1 X0.5 Y0.5\nM84\n";
}

// Of the longest train of X's edges whose intervals are within one clock of 400.
struct Train {
  std::size_t intervals = 0;
  std::int64_t cycles = 0, least = 0, most = 0;
};
Train longest_train(const std::vector<Edge>& edges) {
  constexpr std::int64_t wanted = 400;  // of 4 MHz: 10 kHz
  Train best, now;
  std::int64_t last = -1;
  for (const Edge& edge : edges) {
    if (!edge.what.starts_with("x")) continue;
    const std::int64_t interval = edge.cycle - last;
    last = edge.cycle;
    if (std::abs(interval - wanted) > 1) {
      now = {};
      continue;
    }
    now.least = now.intervals == 0 ? interval : std::min(now.least, interval);
    now.most = now.intervals == 0 ? interval : std::max(now.most, interval);
    ++now.intervals;
    now.cycles += interval;
    if (now.intervals > best.intervals) best = now;
  }
  return best;
}

void report(const char* name, const Train& train) {
  std::printf("%s: train of %zu intervals of %lld to %lld clocks, %.3f Hz\n", name, train.intervals,
              static_cast<long long>(train.least), static_cast<long long>(train.most),
              4e6 * static_cast<double>(train.intervals) / static_cast<double>(train.cycles));
}

TEST_F(Flood, bends_no_pulse_of_a_print) {
  const std::string text = print_of(flood_seconds);
  const std::string flood = gcode_of(static_cast<std::size_t>(largest_bytes));
  begin_chip("real", {"--warm"});
  begin_spooler("chip=" + (folder / "port").string());
  ASSERT_EQ(upload(text), "201");
  clear_bed("chip");
  expect_soon([&] { return done() > 7; }, "it does not print");
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> pause(shortest_pause_s, longest_pause_s);
  const auto begin = Clock::now();
  int uploads = 0;
  double bytes = 0;
  while (job_state() != "finished") {  // the flood lasts as long as the print
    const auto size = static_cast<std::size_t>(log_uniform(smallest_bytes, largest_bytes, random));
    const auto next = Clock::now() + std::chrono::duration<double>(pause(random));
    const int id = upload_held(flood, size);
    ASSERT_GT(id, 0) << "after " << uploads << " uploads";
    ++uploads;
    bytes += static_cast<double>(size);
    std::this_thread::sleep_until(next);
    if (uploads > 3) remove(id - 2);
  }
  const double seconds = seconds_since(begin);
  end_chip();
  expect_edges_of_print(text, {"--warm"});

  const json made = json::parse(files::text_of(folder / "report" / "report.json"));
  const json alone = json::parse(files::text_of(folder / "alone" / "report.json"));
  EXPECT_EQ(made.at("queue").at("underruns"), 0);
  EXPECT_LE(made.at("hotend").at("band_c"), 1.0);
  EXPECT_GE(uploads, 2);
  std::printf("%d uploads, %.1f MB in %.0f s; underruns %d; hotend within %.2f C, alone %.2f C\n",
              uploads, bytes / 1e6, seconds, made.at("queue").at("underruns").get<int>(),
              made.at("hotend").at("band_c").get<double>(),
              alone.at("hotend").at("band_c").get<double>());
  const Train train = longest_train(host_test::edges_of(folder / "edges"));
  const Train train_alone = longest_train(host_test::edges_of(folder / "alone.edges"));
  report("with the flood", train);
  report("alone", train_alone);
  EXPECT_GE(train.intervals, 10'000u);
  EXPECT_EQ(train.cycles, 400 * static_cast<std::int64_t>(train.intervals)) << "10 000.000 Hz";
  EXPECT_EQ(train.least, 400);
  EXPECT_EQ(train.most, 400);
}

// Reported, and not judged: it depends on the machine.
TEST_F(Flood, reports_the_speed_of_an_upload_and_of_the_disk) {
  const auto bytes = static_cast<std::size_t>(1e6 * number_of("UPLOAD_MB", 20));
  const std::string text = gcode_of(bytes);
  begin_spooler("chip=/dev/null");
  for (int i = 0; i < 3; ++i) {
    auto begin = Clock::now();
    const int descriptor =
        open((folder / "plain").c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    ASSERT_EQ(write(descriptor, text.data(), bytes), static_cast<ssize_t>(bytes));
    ASSERT_EQ(fsync(descriptor), 0);
    close(descriptor);
    const double disk = seconds_since(begin);
    begin = Clock::now();
    const int id = upload_held(text, bytes);
    const double upload = seconds_since(begin);
    ASSERT_GT(id, 0);
    remove(id);
    std::printf("%.0f MB: upload %.0f MB/s, written and synchronised %.0f MB/s\n",
                static_cast<double>(bytes) / 1e6, static_cast<double>(bytes) / 1e6 / upload,
                static_cast<double>(bytes) / 1e6 / disk);
  }
}

}  // namespace
