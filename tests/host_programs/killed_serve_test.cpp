// SPDX-License-Identifier: Apache-2.0
// `kill -9` of `serve` while a host prints through it, and the next `serve` on the same port.
#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>

#include "tests/host_programs/serve_fixture.hpp"

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::Not;

class KilledServe : public host_programs::Serve {
 protected:
  KilledServe() {
    fs::create_directories(file_path("report"));
    // From an earlier job.
    for (const char* name : {"report/report.json", "report/report.html"}) {
      std::ofstream(file_path(name)) << "\"result\": \"completed\"";
    }
  }

  // Moves to and fro, some lines unanswered at any time, until so many bytes of edges are there.
  void print_until_edges_have(int host, std::uintmax_t bytes) {
    write_text(host, "G28 X\n");
    ASSERT_THAT(read_until(host, "ok"), HasSubstr("ok"));
    const auto end = std::chrono::steady_clock::now() + host_programs::timeout;
    write_text(host, "G1 X20 F6000\n");
    for (int line = 0; fs::file_size(file_path("edges")) < bytes; ++line) {
      ASSERT_LT(std::chrono::steady_clock::now(), end) << "too few edges";
      write_text(host, line % 2 == 0 ? "G1 X0\n" : "G1 X20\n");
      ASSERT_THAT(read_until(host, "ok"), HasSubstr("ok"));
    }
  }
};

// Each row whole, in order of time, and each step by one from where the axis was.
void expect_whole_rows(const std::string& text) {
  ASSERT_EQ(text.back(), '\n') << "ends with " << text.substr(text.rfind('\n') + 1);
  std::istringstream rows(text);
  std::string row;
  std::getline(rows, row);
  EXPECT_EQ(row, "cycle,axis,direction,position");
  std::map<char, long> position;
  long before = 0;
  while (std::getline(rows, row)) {
    long cycle = 0, direction = 0, place = 0;
    char axis = 0, rest = 0;
    ASSERT_EQ(
        std::sscanf(row.c_str(), "%ld,%c,%ld,%ld%c", &cycle, &axis, &direction, &place, &rest), 4)
        << row;
    ASSERT_LE(before, cycle) << row;
    before = cycle;
    if (position.contains(axis)) {
      ASSERT_EQ(position[axis] + direction, place) << row;
    }
    position[axis] = place;
  }
}

TEST_F(KilledServe, leaves_whole_rows_no_stale_report_and_a_port_for_the_next_one) {
  const std::vector<std::string> options{"--clock-hz", "4000000", "--edges", file_path("edges")};
  start(options);
  int host = open_port();
  ASSERT_TRUE(connect(host));
  constexpr std::uintmax_t bytes = 100'000;
  print_until_edges_have(host, bytes);
  kill_at_once();

  // The host sees that the port is closed.
  char byte = 0;
  ssize_t count = 1;
  while (count > 0) count = read(host, &byte, 1);
  close(host);
  EXPECT_GE(fs::file_size(file_path("edges")), bytes);
  expect_whole_rows(file("edges"));
  EXPECT_THAT(file("accepted"), HasSubstr("-\tG28 X\n"));
  EXPECT_EQ(file("accepted").back(), '\n');
  for (const char* name : {"report/report.json", "report/report.html"}) {
    EXPECT_THAT(file(name), HasSubstr("has not ended")) << name;
    EXPECT_THAT(file(name), Not(HasSubstr("completed"))) << name;
  }

  // The next one takes over the port, and removes the files of both.
  ASSERT_TRUE(fs::is_symlink(fs::symlink_status(port)));
  start(options);
  EXPECT_EQ(locks().size(), 1u);
  host = open_port();
  EXPECT_TRUE(connect(host));
  close(host);
  EXPECT_EQ(stop(), 0);
  EXPECT_FALSE(fs::exists(fs::symlink_status(port)));
  EXPECT_TRUE(locks().empty());
  EXPECT_THAT(file("report/report.json"), HasSubstr("\"result\": \"stopped\""));
}

}  // namespace
