// SPDX-License-Identifier: Apache-2.0
// Many requests and many connections: what is too much is refused, and a person gets in.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>
#include <vector>

#include "host/web/listener.hpp"
#include "tests/host/raw_client.hpp"
#include "tests/host/web_fixture.hpp"

namespace {

using namespace std::chrono_literals;
using host_test::raw;
using host_test::WebTest;
using testing::HasSubstr;

TEST_F(WebTest, refuses_requests_beyond_the_rate_but_an_emergency_stop_comes_through) {
  serve({.key = "0123456789abcdef", .names = {}, .rate = {.burst = 30, .per_second = 0}});
  const httplib::Headers key{{"X-Api-Key", "0123456789abcdef"}};
  EXPECT_EQ(client().Get("/api/v1/state", key)->status, 200);
  EXPECT_EQ(client().Get("/api/v1/state", {{"X-Api-Key", "0123456789abcdeF"}})->status, 403);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(client().Get("/api/v1/state", key)->status, 200) << i;
  const auto refused = client().Get("/api/v1/state", key);
  EXPECT_EQ(refused->status, 429) << "30 requests, of which the wrong key has used 21";
  EXPECT_EQ(refused->get_header_value("Retry-After"), "1");
  expect_soon([&] { return printer_state().at("link") == "ready"; }, "the printer is not ready");
  EXPECT_EQ(posted("/api/v1/printers/left/stop", nlohmann::json::object(), key), 200);
  EXPECT_EQ(posted("/api/v1/printers/left/stop"), 403) << "but not without the key";
}

TEST_F(WebTest, counts_heads_that_can_be_read_in_two_ways) {
  serve({.key = {}, .names = {}, .rate = {.burst = 3, .per_second = 0}});
  const std::string faulty = "GET / HTTP/1.1\r\nHost: localhost\r\nHost: evil.example\r\n\r\n";
  for (int i = 0; i < 3; ++i) EXPECT_THAT(raw(port(), faulty), HasSubstr(" 400 ")) << i;
  EXPECT_THAT(raw(port(), faulty), HasSubstr(" 429 "));
}

// More than are queued for the workers.
TEST(listener, answers_each_request_of_a_burst) {
  web::Listener listener({}, 2);
  listener.Get("/slow", [](const httplib::Request&, httplib::Response& response) {
    std::this_thread::sleep_for(1ms);
    response.set_content("here", "text/plain");
  });
  const int port = listener.bind({.host = "127.0.0.1", .port = 0}).port;
  std::thread server([&] { listener.listen_after_bind(); });
  listener.wait_until_ready();
  std::vector<std::unique_ptr<host_test::RawClient>> burst;
  for (int i = 0; i < 600; ++i) {
    burst.push_back(std::make_unique<host_test::RawClient>(port));
    burst.back()->say("GET /slow HTTP/1.1\r\nHost: localhost\r\n\r\n");
  }
  EXPECT_EQ(
      std::ranges::count_if(burst, [](const auto& one) { return one->all().ends_with("here"); }),
      600);
  listener.end();
  listener.stop();
  server.join();
}

// So many files may be open in this process, until the end of the scope. Others keep low numbers,
// for select() of a client takes no others.
class ManyFiles {
 public:
  static constexpr int first = 1024;
  explicit ManyFiles(rlim_t count) {
    getrlimit(RLIMIT_NOFILE, &before_);
    rlimit more = before_;
    more.rlim_cur = count;
    is_enough = count <= before_.rlim_max && setrlimit(RLIMIT_NOFILE, &more) == 0;
  }
  ~ManyFiles() {
    for (const int one : open) close(one);
    setrlimit(RLIMIT_NOFILE, &before_);
  }
  ManyFiles(const ManyFiles&) = delete;
  ManyFiles& operator=(const ManyFiles&) = delete;

  bool add(int file) {
    const int moved = fcntl(file, F_DUPFD_CLOEXEC, first);
    close(file);
    if (moved >= 0) open.push_back(moved);
    return moved >= 0;
  }

  bool is_enough = false;
  std::vector<int> open;

 private:
  rlimit before_{};
};

bool begin_to_connect(ManyFiles& idle, int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const int one = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (one < 0) return false;
  (void)connect(one, reinterpret_cast<sockaddr*>(&address), sizeof address);
  return idle.add(one);
}

// Also where it has been ended since.
bool has_connected(int socket) {
  pollfd waiting{.fd = socket, .events = POLLOUT, .revents = 0};
  return poll(&waiting, 1, 0) > 0;
}

// As of a program that opens connections without end.
TEST_F(WebTest, prints_and_serves_a_person_although_ten_thousand_connections_are_idle) {
  constexpr int crowd = 10'000;
  ManyFiles idle(ManyFiles::first + crowd + 100);
  if (!idle.is_enough) GTEST_SKIP() << "this user may not open so many files";
  serve({}, {.patience = 1h});
  const auto printed = upload_moves(300);
  expect_state(printed, queue::JobState::queued);
  for (int i = 1; i <= crowd; ++i) {
    ASSERT_TRUE(begin_to_connect(idle, port())) << i;
    if (i % 1000 == 0) {
      const auto state = client().Get("/api/v1/state");
      ASSERT_TRUE(state) << i;
      EXPECT_EQ(state->status, 200) << i;
    }
  }
  expect_soon([&] { return std::ranges::all_of(idle.open, has_connected); }, "not all connected");
  EXPECT_EQ(idle.open.size(), static_cast<std::size_t>(crowd));
  const auto answer = client().Post("/api/v1/jobs", form("G28 X\n", "a.gcode", "false"));
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 201);
  EXPECT_EQ(posted("/api/v1/printers/left/bed_clear", {{"clear", true}}), 200);
  expect_printed(printed);
}

}  // namespace
