// SPDX-License-Identifier: Apache-2.0
// Clients that send slowly or nothing: each is ended, and others are served meanwhile.
#include <gmock/gmock.h>

#include <algorithm>
#include <memory>

#include "tests/host/raw_client.hpp"
#include "tests/host/web_fixture.hpp"

namespace {

using namespace std::chrono_literals;
using host_test::RawClient;
using host_test::WebTest;
using testing::HasSubstr;

// Requests that have not ended, by what is missing.
const std::vector<std::string> unfinished{
    "GET / HTTP/1.1\r\nX: ",
    "GET /api/v1/state HTTP/1.1\r\nHost: localhost\r\n",
    "POST /api/v1/jobs/1/hold HTTP/1.1\r\nHost: localhost\r\nContent-Length: 5000\r\n\r\n{",
    "POST /api/v1/jobs HTTP/1.1\r\nHost: localhost\r\nContent-Type: multipart/form-data; "
    "boundary=xyz\r\nContent-Length: 5000\r\n\r\n",
    "POST /api/v1/jobs HTTP/1.1\r\nHost: localhost\r\nContent-Type: multipart/form-data; "
    "boundary=xyz\r\nContent-Length: 5000\r\n\r\n--xy",
    "POST /api/v1/jobs HTTP/1.1\r\nHost: localhost\r\nContent-Type: multipart/form-data; "
    "boundary=xyz\r\nContent-Length: 5000\r\n\r\n--xyz\r\nContent-Disposition: form",
    "POST /api/v1/jobs HTTP/1.1\r\nHost: localhost\r\nContent-Type: multipart/form-data; "
    "boundary=xyz\r\nTransfer-Encoding: chunked\r\n\r\n"};

TEST_F(WebTest, a_request_that_comes_byte_by_byte_is_ended_with_a_reason) {
  serve({}, {.patience = 500ms});
  for (const std::string& begin : unfinished) {
    const RawClient slow(port());
    slow.say(begin);
    int bytes = 0;
    while (!slow.hears() && bytes < 300) {  // without an end of it, half a minute
      slow.say("0");
      ++bytes;
      std::this_thread::sleep_for(100ms);
    }
    EXPECT_LT(bytes, 300) << begin;
    EXPECT_THAT(slow.all(), HasSubstr(" 408 ")) << begin;
  }
  EXPECT_TRUE(std::filesystem::is_empty(data() / "files"));
}

TEST_F(WebTest, a_slow_upload_that_is_fast_enough_arrives) {
  serve({}, {.patience = 500ms, .bytes_per_second = 100});
  const std::string body =
      "--xyz\r\nContent-Disposition: form-data; name=\"file\"; filename=\"a.gcode\"\r\n\r\n" +
      std::string(3000, ';') + "\r\n--xyz--\r\n";
  const RawClient slow(port());
  slow.say(
      "POST /api/v1/jobs HTTP/1.1\r\nHost: localhost\r\nContent-Type: multipart/form-data; "
      "boundary=xyz\r\nContent-Length: " +
      std::to_string(body.size()) + "\r\n\r\n");
  for (std::size_t at = 0; at < body.size(); at += 100) {  // for some times the patience
    slow.say(body.substr(at, 100));
    std::this_thread::sleep_for(60ms);
  }
  EXPECT_THAT(slow.all(), HasSubstr(" 201 "));
}

TEST_F(WebTest, serves_others_while_hundreds_send_nothing_more) {
  serve({}, {.patience = 1h});  // only the others can push them out
  std::vector<std::unique_ptr<RawClient>> slow;
  for (int i = 0; i < 300; ++i) {
    slow.push_back(std::make_unique<RawClient>(port()));
    slow.back()->say(unfinished[static_cast<std::size_t>(i) % unfinished.size()]);
    if (i % 50 == 49) {
      EXPECT_EQ(got("/api/v1/state").at("jobs").size(), 0u) << i;
    }
  }
  const auto is_waited_for = [](const auto& each) { return !each->hears(); };
  expect_soon(
      [&] {
        return std::ranges::count_if(slow, is_waited_for) <=
               static_cast<std::ptrdiff_t>(web::WaitLimits{}.most_waiting);
      },
      "too many are waited for");
  const auto answer = client().Post("/api/v1/jobs", form("G28 X\n", "a.gcode", "false"));
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 201);
}

TEST_F(WebTest, all_streams_of_events_leave_workers_for_others) {
  std::vector<std::unique_ptr<RawClient>> streams;
  for (int i = 0; i < 16; ++i) {
    streams.push_back(std::make_unique<RawClient>(port()));
    streams.back()->say("GET /api/v1/events HTTP/1.1\r\nHost: localhost\r\n\r\n");
    expect_soon([&] { return streams.back()->hears(); }, "no event");
  }
  for (int i = 0; i < 40; ++i) {
    streams.push_back(std::make_unique<RawClient>(port()));
    streams.back()->say(unfinished[0]);
  }
  EXPECT_EQ(client().Get("/api/v1/state")->status, 200);
  EXPECT_EQ(client().Get("/api/v1/events")->status, 503);
}

}  // namespace
