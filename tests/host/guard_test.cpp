// SPDX-License-Identifier: Apache-2.0
// Addresses, names, origins and keys.
#include "host/web/guard.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "host/web/address.hpp"
#include "tests/temporary_folder.hpp"

namespace {

using namespace web;

TEST(address, is_read_and_written) {
  EXPECT_EQ(address_of("127.0.0.1:80"), (Address{"127.0.0.1", 80}));
  EXPECT_EQ(address_of("0.0.0.0"), (Address{"0.0.0.0", usual_port}));
  EXPECT_EQ(address_of("[::1]:90"), (Address{"::1", 90}));
  EXPECT_EQ(address_of("::1"), (Address{"::1", usual_port}));
  EXPECT_EQ(address_of(":81"), (Address{"127.0.0.1", 81}));
  EXPECT_EQ(written({"::1", 90}), "[::1]:90");
  EXPECT_EQ(written({"localhost", 90}), "localhost:90");
  for (const char* wrong : {"a:", "a:b", "a:65536", "[::1", "[::1]90", "a:1x", "a:-1"}) {
    EXPECT_THROW(address_of(wrong), std::runtime_error) << wrong;
  }
}

TEST(address, only_this_machine_s_own_are_loopback) {
  for (const char* own : {"localhost", "127.0.0.1", "127.8.9.1", "::1"}) {
    EXPECT_TRUE(is_loopback(own)) << own;
  }
  for (const char* other : {"0.0.0.0", "::", "192.168.0.1", "127.example.org", "127.0.0.1.x", ""}) {
    EXPECT_FALSE(is_loopback(other)) << other;
  }
}

TEST(own_name, is_an_address_or_a_name_that_was_given) {
  for (const char* own : {"localhost", "LocalHost:80", "127.0.0.1:5080", "192.168.1.7", "[::1]:80",
                          "printer.lan:80", "PRINTER.lan"}) {
    EXPECT_TRUE(is_own_name(own, {"printer.lan"})) << own;
  }
  for (const char* other : {"", "evil.example", "localhost.evil.example", "127.0.0.1.evil.example",
                            "printer.lan.evil.example", "[evil]", "[::1",
                            "localhost:", "localhost:x", "evil.example:80@localhost"}) {
    EXPECT_FALSE(is_own_name(other, {"printer.lan"})) << other;
  }
}

constexpr std::string_view here = "192.0.2.1";

RequestHead request(const std::string& method, const std::string& path = "/api/job") {
  return {.method = method,
          .path = path,
          .host = "localhost:5080",
          .origin = {},
          .fetch_site = {},
          .key = {},
          .token = {},
          .fault = {}};
}

// Of a server that has answered nothing yet.
std::optional<Refusal> refusal_of(const RequestHead& head, const Rules& rules = {}) {
  return Guard(rules).refusal_of(head, here);
}

int status_of(Guard& guard, const RequestHead& head, std::string_view client = here) {
  const auto refusal = guard.refusal_of(head, client);
  return refusal ? refusal->status : 200;
}

TEST(guard, lets_programs_of_this_machine_and_its_own_page_do_everything) {
  RequestHead post = request("POST");
  EXPECT_FALSE(refusal_of(post));
  post.origin = "http://localhost:5080";
  post.fetch_site = "same-origin";
  EXPECT_FALSE(refusal_of(post));
  post.origin = "https://localhost:5080";
  EXPECT_FALSE(refusal_of(post)) << "through a proxy with TLS";
}

TEST(guard, lets_pages_of_other_sites_change_nothing) {
  for (const char* method : {"POST", "PUT", "DELETE", "PATCH", "UNKNOWN"}) {
    for (const char* origin : {"http://evil.example", "null", "", "ftp://localhost:5080",
                               "http://localhost:5081", "http://localhost:5080.evil.example"}) {
      RequestHead forged = request(method);
      forged.origin = origin;
      EXPECT_EQ(refusal_of(forged).value().status, 403) << method << " " << origin;
    }
    RequestHead forged = request(method);
    forged.fetch_site = "cross-site";
    EXPECT_TRUE(refusal_of(forged)) << method;
  }
}

TEST(guard, refuses_names_that_are_not_its_own_for_every_method) {
  for (const char* method : {"GET", "HEAD", "POST"}) {
    RequestHead rebound = request(method, "/");
    rebound.host = "evil.example:5080";
    rebound.origin = "http://evil.example:5080";
    EXPECT_TRUE(refusal_of(rebound)) << method;
  }
}

TEST(guard, wants_the_key_for_all_but_the_page) {
  const Rules rules{.key = "0123456789abcdef", .names = {}};
  for (const char* path : {"/api/version", "/api/v1/events", "/printers/a/api/job", "//api/job",
                           "/page.js/../api/job", "/x"}) {
    RequestHead get = request("GET", path);
    EXPECT_TRUE(refusal_of(get, rules)) << path;
    for (const char* wrong : {"", "0123456789abcdee", "0123456789abcde", "0123456789abcdef0"}) {
      get.key = wrong;
      EXPECT_TRUE(refusal_of(get, rules)) << path << " " << wrong;
    }
    get.key = rules.key;
    EXPECT_FALSE(refusal_of(get, rules)) << path;
  }
  for (const char* path : {"/", "/page.js", "/page.css"}) {
    EXPECT_FALSE(refusal_of(request("GET", path), rules)) << path;
  }
}

const std::string stop = "/api/v1/printers/left/stop";

TEST(guard, counts_refused_requests_and_faulty_heads_too) {
  RequestHead faulty = request("GET"), foreign = request("GET"), forged = request("POST");
  faulty.fault = Refusal{.status = 400, .why = "two hosts"};
  foreign.host = "evil.example";
  forged.origin = "http://evil.example";
  for (const auto& [head, status] : {std::pair(faulty, 400), {foreign, 403}, {forged, 403}}) {
    Guard guard({.key = {}, .names = {}, .rate = {.burst = 5, .per_second = 0}});
    for (int i = 0; i < 5; ++i) EXPECT_EQ(status_of(guard, head), status);
    EXPECT_EQ(status_of(guard, head), 429);
    EXPECT_EQ(status_of(guard, request("GET")), 429);
    EXPECT_EQ(status_of(guard, request("GET"), "192.0.2.2"), 200) << "another client";
  }
}

TEST(guard, gives_emergency_stops_a_limit_of_their_own) {
  Guard guard({.key = {},
               .names = {},
               .rate = {.burst = 0, .per_second = 0},
               .stop_rate = {.burst = 2, .per_second = 0}});
  EXPECT_EQ(status_of(guard, request("GET")), 429);
  EXPECT_EQ(status_of(guard, request("POST", stop)), 200) << "although all others are used up";
  EXPECT_EQ(status_of(guard, request("POST", stop)), 200);
  EXPECT_EQ(status_of(guard, request("POST", stop)), 429);
  EXPECT_EQ(status_of(guard, request("POST", stop), "192.0.2.2"), 200) << "another client";
}

TEST(guard, usually_takes_some_emergency_stops_at_once) {
  Guard guard({});
  int taken = 0;
  while (taken < 400 && status_of(guard, request("POST", stop)) == 200) ++taken;
  EXPECT_GE(taken, 20);
  EXPECT_LT(taken, 400) << "fewer than other requests";
}

TEST(guard, lets_no_client_try_keys_with_emergency_stops) {
  Guard guard(
      {.key = "0123456789abcdef", .names = {}, .stop_rate = {.burst = 20, .per_second = 0}});
  RequestHead guess = request("POST", stop);
  guess.key = "0123456789abcdee";
  EXPECT_EQ(status_of(guard, guess), 403);
  guess.key = "0123456789abcdef";
  EXPECT_EQ(status_of(guard, guess), 429) << "also the right one, so that nothing is learnt";
}

TEST(guard, takes_for_an_emergency_stop_the_route_of_one_printer_alone) {
  for (const char* other : {"/api/v1/printers//stop", "/api/v1/printers/stop",
                            "/api/v1/printers/left/x/stop", "/api/v1/printers/left/stop/",
                            "/api/v1/printers/left/pause", "/x/api/v1/printers/left/stop",
                            "/api/v1/printers/../state?/stop", "/api/v1/printers/left//stop"}) {
    Guard guard({.key = {}, .names = {}, .rate = {.burst = 1, .per_second = 0}});
    EXPECT_EQ(status_of(guard, request("POST", other)), 200) << other;
    EXPECT_EQ(status_of(guard, request("POST", other)), 429) << other;
  }
  Guard guard({.key = {}, .names = {}, .rate = {.burst = 1, .per_second = 0}});
  EXPECT_EQ(status_of(guard, request("GET", stop)), 200);
  EXPECT_EQ(status_of(guard, request("GET", stop)), 429) << "it stops nothing";
}

TEST(key, is_the_first_line_of_a_file_that_others_cannot_read) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "key";
  const auto write = [&](const std::string& text, int mode) {
    folder.write("key", text);
    std::filesystem::permissions(file, static_cast<std::filesystem::perms>(mode));
  };
  write("0123456789abcdef\nmore\n", 0600);
  EXPECT_EQ(read_key(file), "0123456789abcdef");
  write("0123456789abcdef\n", 0640);
  EXPECT_THROW(read_key(file), std::runtime_error);
  write("0123456789abcde\n", 0600);
  EXPECT_THROW(read_key(file), std::runtime_error) << "too short";
  write("0123456789 abcdef\n", 0600);
  EXPECT_THROW(read_key(file), std::runtime_error);
  write("", 0600);
  EXPECT_THROW(read_key(file), std::runtime_error);
  EXPECT_THROW(read_key(folder.path() / "none"), std::runtime_error);
}

}  // namespace
