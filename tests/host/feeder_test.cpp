// SPDX-License-Identifier: Apache-2.0
// The feeder as a process, at a pseudo-terminal: damaged lines, an unplugged cable, kill -9, and no
// spooler to be seen.
#include <gmock/gmock.h>
#include <poll.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <thread>

#include "directories.hpp"
#include "host/feeder/feeder.hpp"
#include "host/feeder/local_socket.hpp"
#include "host/queue/lease.hpp"
#include "tests/host/pty_printer.hpp"
#include "tests/temporary_folder.hpp"
#include "tools/process/process.hpp"

namespace {

using namespace std::chrono_literals;
using Json = nlohmann::json;
using Clock = std::chrono::steady_clock;
constexpr auto patience = 60s;  // on a machine under load

class FeederTest : public testing::Test {
 protected:
  FeederTest() { begin_feeder(); }

  process::Start call() const {
    return {.arguments = {BUILD_DIRECTORY "/bin/stepfabric_feeder", "--folder", folder_of_feeder(),
                          "--port", (folder.path() / "port").string()},
            .has_input = false};
  }
  void begin_feeder() { process.emplace(call()); }
  void kill_feeder() {
    process->signal(SIGKILL);
    process->wait();
    process.reset();
  }
  std::string folder_of_feeder() const { return (folder.path() / "feeder").string(); }

  // As the spooler does it.
  void connect() {
    const auto end = Clock::now() + patience;
    connection.reset();
    while (Clock::now() < end) {
      connection.emplace(feeder::connect_to(folder_of_feeder(), feeder::socket_name));
      if (connection->is_open()) return;
      std::this_thread::sleep_for(20ms);
    }
    FAIL() << "the feeder does not listen";
  }
  // The first message that fits, or the last that came.
  Json message(const std::function<bool(const Json&)>& fits) {
    const auto end = Clock::now() + patience;
    Json last;
    while (Clock::now() < end && connection->is_open()) {
      for (const std::string& line : connection->exchange()) {
        last = Json::parse(line);
        if (fits(last)) return last;
      }
      std::this_thread::sleep_for(5ms);
    }
    ADD_FAILURE() << "not what was waited for: " << last.dump();
    return last;
  }
  Json state_with(const std::string& key, const Json& value) {
    return message([&](const Json& each) {
      return each.at("event") == "state" && each.value(key, Json()) == value;
    });
  }
  std::string refusal_of(Json wish) {
    connection->send(wish.dump());
    return message([&](const Json& each) {
             return each.at("event") == "answer" && each.at("do") == wish.at("do");
           })
        .at("refused");
  }
  void start_job(int lines) {
    std::string text;
    for (int i = 1; i <= lines; ++i) {
      wanted.push_back("G1 X" + std::to_string(i));
      text += wanted.back() + "\n";
    }
    folder.write("job", text);
    connect();
    state_with("link", "ready");
    ASSERT_EQ(refusal_of({{"do", "start"},
                          {"job", 3},
                          {"file", (folder.path() / "job").string()},
                          {"commands", lines}}),
              "");
  }
  void wait_until_executed(std::size_t lines) {
    const auto end = Clock::now() + patience;
    while (printer.executed().size() < lines && Clock::now() < end) {
      std::this_thread::sleep_for(1ms);
    }
    ASSERT_GE(printer.executed().size(), lines);
  }

  TemporaryFolder folder;
  host_test::PtyPrinter printer{folder.path() / "port"};
  std::optional<process::Process> process;
  std::optional<feeder::Connection> connection;
  std::vector<std::string> wanted;
};

TEST_F(FeederTest, prints_although_lines_are_damaged_and_an_ok_is_lost) {
  start_job(400);
  for (std::size_t lines = 50; lines < 400; lines += 50) {
    wait_until_executed(lines);
    printer.damage_next_byte();
  }
  printer.with([](host_test::LinkPrinter& each) { each.lose_next_ok(); });
  const Json state = state_with("phase", "finished");
  EXPECT_EQ(printer.executed(), wanted);
  EXPECT_GE(state.at("resends"), 5);
  EXPECT_EQ(state.at("done"), 400);
  EXPECT_EQ(state.at("hotend").at(0), 21.5);
}

// Where its spooler stood still, another one may have the printer by then.
TEST_F(FeederTest, begins_no_job_whose_start_comes_after_the_end_of_the_printers_lease) {
  folder.write("job", "G1 X1\n");
  connect();
  state_with("link", "ready");
  Json wish{{"do", "start"},
            {"job", 3},
            {"file", (folder.path() / "job").string()},
            {"commands", 1},
            {"not_after_ms", queue::boot_ms() - 1}};
  EXPECT_THAT(refusal_of(wish), testing::HasSubstr("lease"));
  std::this_thread::sleep_for(300ms);
  EXPECT_EQ(printer.executed().size(), 0u);
  wish["not_after_ms"] = queue::boot_ms() + 60'000;
  EXPECT_EQ(refusal_of(wish), "");
  state_with("phase", "finished");
  EXPECT_EQ(printer.executed().size(), 1u);
}

TEST_F(FeederTest, goes_on_when_the_cable_is_in_again) {
  start_job(400);
  for (std::size_t lines = 100; lines < 400; lines += 100) {
    wait_until_executed(lines);
    printer.unplug();
    state_with("link", "closed");
    printer.plug_in();
    state_with("link", "ready");
  }
  state_with("phase", "finished");
  EXPECT_EQ(printer.executed(), wanted);
}

TEST_F(FeederTest, killed_at_random_instants_goes_on_at_the_right_line) {
  start_job(2000);
  std::mt19937 random(1);
  for (int kills = 0; kills < 15; ++kills) {
    const std::size_t before = printer.executed().size();
    wait_until_executed(before + 10 + random() % 80);
    ASSERT_LT(printer.executed().size(), wanted.size()) << "killed when all was done";
    kill_feeder();
    begin_feeder();
  }
  connect();
  const Json state = state_with("phase", "finished");
  EXPECT_EQ(state.at("job"), 3);
  EXPECT_EQ(printer.executed(), wanted);
}

TEST_F(FeederTest, prints_on_without_a_spooler_and_keeps_the_outcome) {
  start_job(300);
  connection.reset();
  wait_until_executed(300);
  connect();
  state_with("phase", "finished");
  kill_feeder();
  begin_feeder();
  connect();
  state_with("phase", "finished");
  EXPECT_EQ(refusal_of({{"do", "forget"}, {"job", 3}}), "");
  kill_feeder();
  begin_feeder();
  connect();
  state_with("phase", Json());
}

TEST_F(FeederTest, a_lost_ok_stops_nothing_although_the_printer_reports_by_itself) {
  connect();
  const auto end = Clock::now() + patience;
  bool reports = false;
  while (!reports && Clock::now() < end) {
    printer.with([&](host_test::LinkPrinter& each) {
      reports = std::ranges::count(each.typed, "M155 S2") > 0;
    });
    std::this_thread::sleep_for(20ms);
  }
  ASSERT_TRUE(reports);
  start_job(400);
  wait_until_executed(50);
  printer.with([](host_test::LinkPrinter& each) { each.lose_next_ok(); });
  state_with("phase", "finished");
  EXPECT_EQ(printer.executed(), wanted);
}

// The journal's spare file is a folder: as with a full disk.
TEST_F(FeederTest, is_cancelled_with_everything_off_although_the_disk_is_full) {
  start_job(2000);
  wait_until_executed(50);
  const auto spare = std::filesystem::path(folder_of_feeder()) / "journal.json.new";
  std::filesystem::remove(spare);
  std::filesystem::create_directory(spare);
  EXPECT_EQ(refusal_of({{"do", "cancel"}}), "");
  EXPECT_EQ(refusal_of({{"do", "cancel"}}), "");
  const Json state = state_with("phase", "cancelled");
  EXPECT_THAT(state.at("fault"), testing::HasSubstr("cannot write"));
  EXPECT_EQ(printer.executed().back(), "M84");
  std::filesystem::remove(spare);
  state_with("fault", "");
  kill_feeder();
  begin_feeder();
  connect();
  state_with("phase", "cancelled");
}

TEST_F(FeederTest, says_why_its_port_cannot_be_opened) {
  connect();
  state_with("link", "ready");
  state_with("fault", "");
  printer.unplug();
  const auto says = [&](const std::string& text) {
    message([&](const Json& each) {
      return each.at("event") == "state" &&
             each.at("fault").get<std::string>().find(text) != std::string::npos;
    });
  };
  says("No such file or directory");
  folder.write("port", "no terminal");
  says("is no serial port");
}

TEST_F(FeederTest, a_second_one_for_the_same_printer_is_refused) {
  connect();
  const auto second = process::capture(call());
  EXPECT_EQ(second.exit_status, 2);
  EXPECT_THAT(second.output, testing::HasSubstr("another feeder"));
  state_with("link", "ready");
}

TEST_F(FeederTest, survives_whatever_comes_over_its_socket) {
  connect();
  for (const char* line : {"", "{", "[]", "{\"do\":5}", "{\"do\":\"start\"}", "{\"do\":\"dance\"}",
                           "{\"do\":\"send\",\"line\":\"G28\\nG29\"}", "\xff\xfe"}) {
    connection->send(line);
    EXPECT_NE(message([](const Json& each) { return each.at("event") == "answer"; }).at("refused"),
              "")
        << line;
  }
  connection->send(std::string(1'000'000, 'x'));
  state_with("link", "ready");
  EXPECT_EQ(refusal_of({{"do", "end"}}), "");
  EXPECT_EQ(process->wait().exit_status, 0);
}

}  // namespace
