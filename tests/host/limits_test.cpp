// SPDX-License-Identifier: Apache-2.0
// Limits of rate and of connections that are waited for, each for its client. Streams of events are
// counted together.
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "host/web/connections.hpp"
#include "host/web/rate.hpp"

namespace {

using namespace std::chrono_literals;
using web::RateLimit;

TEST(rate_limit, lets_a_burst_through_and_then_so_many_a_second) {
  RateLimit limit({.burst = 10, .per_second = 2});
  const RateLimit::Clock::time_point begin{};
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(limit.take("192.0.2.1", begin)) << i;
  EXPECT_FALSE(limit.take("192.0.2.1", begin));
  EXPECT_FALSE(limit.take("192.0.2.1", begin + 400ms));
  EXPECT_TRUE(limit.take("192.0.2.2", begin)) << "another client";
  EXPECT_TRUE(limit.take("192.0.2.1", begin + 1s));
  EXPECT_TRUE(limit.take("192.0.2.1", begin + 1s));
  EXPECT_FALSE(limit.take("192.0.2.1", begin + 1s));
}

TEST(rate_limit, counts_a_wrong_key_as_many_requests) {
  RateLimit limit({.burst = 10, .per_second = 1, .wrong_key = 9});
  const RateLimit::Clock::time_point begin{};
  EXPECT_TRUE(limit.take("192.0.2.1", begin));
  limit.note_wrong_key("192.0.2.1", begin);
  EXPECT_FALSE(limit.take("192.0.2.1", begin));
}

TEST(rate_limit, makes_the_next_wrong_key_wait_for_all_of_its_price) {
  RateLimit limit({.burst = 3, .per_second = 1, .wrong_key = 5});
  const RateLimit::Clock::time_point begin{};
  while (limit.take("192.0.2.1", begin)) {
  }
  int tried = 0;
  for (int second = 1; second <= 60; ++second) {
    if (!limit.take("192.0.2.1", begin + std::chrono::seconds(second))) continue;
    limit.note_wrong_key("192.0.2.1", begin + std::chrono::seconds(second));
    ++tried;
  }
  EXPECT_EQ(tried, 10) << "one, and then one every 6 s: of a request and its wrong key";
}

TEST(rate_limit, takes_the_addresses_of_a_network_for_one_client) {
  EXPECT_EQ(web::client_of("2001:db8::1:2:3:4"), web::client_of("2001:db8::"));
  EXPECT_NE(web::client_of("2001:db8:0:1::1"), web::client_of("2001:db8::1"));
  EXPECT_NE(web::client_of("::ffff:192.0.2.1"), web::client_of("::ffff:192.0.2.2"));
  EXPECT_NE(web::client_of("192.0.2.1"), web::client_of("192.0.2.2"));
}

TEST(rate_limit, remembers_clients_that_have_used_it_up_although_many_others_come) {
  RateLimit limit({.burst = 2, .per_second = 1, .most_addresses = 100});
  const RateLimit::Clock::time_point begin{};
  while (limit.take("192.0.2.1", begin)) {
  }
  for (int i = 0; i < 1000; ++i) limit.take("198.51.100." + std::to_string(i), begin);
  EXPECT_FALSE(limit.take("192.0.2.1", begin));
}

// One end of a connection that is waited for.
struct Waiting {
  Waiting(web::Connections& all, const std::string& client, std::chrono::seconds due)
      : connections(all) {
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
    awaited.socket = ends[0];
    awaited.client = client;
    awaited.due = web::Clock::now() + due;
    connections.enter(awaited);
  }
  ~Waiting() {
    connections.leave(awaited);
    close(ends[0]);
    close(ends[1]);
  }
  Waiting(const Waiting&) = delete;
  Waiting& operator=(const Waiting&) = delete;

  web::Connections& connections;
  std::array<int, 2> ends{};
  web::Awaited awaited;
};

TEST(connections, a_client_with_many_pushes_out_its_own_ones) {
  web::Connections all({.most_waiting = 4});
  const Waiting slow(all, "192.0.2.1", 1s);  // due first
  std::vector<std::unique_ptr<Waiting>> many;
  for (int i = 0; i < 20; ++i) many.push_back(std::make_unique<Waiting>(all, "192.0.2.2", 10s));
  EXPECT_FALSE(slow.awaited.given_up);
  EXPECT_TRUE(many.front()->awaited.given_up);
  EXPECT_FALSE(many.back()->awaited.given_up);
}

// Their threads need some time to end them.
TEST(connections, those_that_are_given_up_count_no_more) {
  web::Connections all({.most_waiting = 4});
  std::vector<std::unique_ptr<Waiting>> many;
  for (int i = 0; i < 8; ++i) many.push_back(std::make_unique<Waiting>(all, "192.0.2.2", 10s));
  const auto given_up = [&] {
    return std::ranges::count_if(many,
                                 [](const auto& each) { return each->awaited.given_up.load(); });
  };
  EXPECT_EQ(given_up(), 4);
  many.pop_back();  // one that is still waited for
  const Waiting another(all, "192.0.2.1", 10s);
  EXPECT_EQ(given_up(), 4) << "four are waited for, which is not too many";
  const Waiting last(all, "192.0.2.1", 1s);
  EXPECT_EQ(given_up(), 5) << "of the client that has three, not of the one with two";
}

}  // namespace
