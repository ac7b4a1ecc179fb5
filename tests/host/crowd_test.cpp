// SPDX-License-Identifier: Apache-2.0
// Many requests and many connections: what is too much is refused, and a person gets in.
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <vector>

#include "tests/host/web_fixture.hpp"

namespace {

using namespace std::chrono_literals;
using host_test::WebTest;

TEST_F(WebTest, refuses_requests_beyond_the_rate_but_never_the_emergency_stop) {
  serve({.key = "0123456789abcdef", .names = {}, .rate = {.burst = 30, .per_second = 0}});
  const httplib::Headers key{{"X-Api-Key", "0123456789abcdef"}};
  EXPECT_EQ(client().Get("/api/v1/state", key)->status, 200);
  EXPECT_EQ(client().Get("/api/v1/state", {{"X-Api-Key", "0123456789abcdeF"}})->status, 403);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(client().Get("/api/v1/state", key)->status, 200) << i;
  const auto refused = client().Get("/api/v1/state", key);
  EXPECT_EQ(refused->status, 429) << "30 requests, of which the wrong key has used 21";
  EXPECT_EQ(refused->get_header_value("Retry-After"), "1");
  EXPECT_NE(posted("/api/v1/printers/left/stop", {}, key), 429);
  EXPECT_EQ(posted("/api/v1/printers/left/stop"), 403) << "but not without the key";
}

// As of a program that opens connections without end. That printing goes on is seen in print_test.
TEST_F(WebTest, serves_a_person_although_ten_thousand_connections_are_idle) {
  serve({}, {.patience = 1h});
  std::vector<int> idle;
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port()));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  for (int i = 0; i < 10'000; ++i) {
    const int one = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (one < 0) {
      break;  // this process may have no more
    }
    idle.push_back(one);
    (void)connect(one, reinterpret_cast<sockaddr*>(&address), sizeof address);
    if (i % 1000 == 999) {
      EXPECT_EQ(client().Get("/api/v1/state")->status, 200) << i + 1;
    }
  }
  EXPECT_GE(idle.size(), 500u);
  const auto answer = client().Post("/api/v1/jobs", form("G28 X\n", "a.gcode", "false"));
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 201);
  for (const int one : idle) close(one);
}

}  // namespace
