// SPDX-License-Identifier: Apache-2.0
// What keys that are tried, floods and slow readers cost, and that they keep no one else out.
#include <gmock/gmock.h>
#include <signal.h>

#include <fstream>
#include <memory>

#include "tests/host/raw_client.hpp"
#include "tests/moonraker/fixture.hpp"

namespace {

using namespace std::chrono_literals;
using host_test::RawClient;
using moonraker_test::Json;
using moonraker_test::MoonrakerTest;
using moonraker_test::SocketClient;

const std::string key = "a_key_of_16_or_more_characters";
constexpr int too_busy = -32000;

class LimitTest : public MoonrakerTest {
 protected:
  void serve_with_key(double burst) {
    serve({.rules = {.key = key, .names = {}, .rate = {.burst = burst, .per_second = 0}}});
  }
  // How many requests this client still has.
  int left() const {
    int count = 0;
    while (http().Get("/access/info")->status == 200) ++count;
    return count;
  }
  static std::string request(const std::string& method, const Json& params, int id) {
    return Json{{"jsonrpc", "2.0"}, {"method", method}, {"params", params}, {"id", id}}.dump();
  }
  static Json identity_with(const std::string& given) {
    Json params = identity();
    params["api_key"] = given;
    return params;
  }
  // Of the next so many messages with an id: how many are errors for too much.
  static int refused_of(SocketClient& client, int answers) {
    int refused = 0;
    while (answers > 0) {
      const auto message = client.receive();
      if (!message) return -1;
      if (!message->contains("id")) continue;
      --answers;
      if (message->contains("error") && message->at("error").at("code") == too_busy) ++refused;
    }
    return refused;
  }
};

TEST_F(LimitTest, a_wrong_key_costs_as_much_in_each_way_in_which_it_can_be_given) {
  const auto log_in = [this] {
    const Json body{{"username", "me"}, {"password", "wrong"}};
    return http().Post("/access/login", body.dump(), "application/json")->status;
  };
  serve_with_key(30);
  EXPECT_EQ(http().Get("/server/info", {{"X-Api-Key", "wrong"}})->status, 401);
  EXPECT_EQ(left(), 9) << "by a header";
  serve_with_key(30);
  EXPECT_EQ(http().Get("/server/info?token=wrong")->status, 401);
  EXPECT_EQ(left(), 9) << "by a token";
  serve_with_key(30);
  EXPECT_EQ(log_in(), 401);
  EXPECT_EQ(left(), 9) << "by a login";
  serve_with_key(30);
  EXPECT_EQ(http()
                .Post("/access/refresh_jwt", R"({"refresh_token":"wrong"})", "application/json")
                ->status,
            401);
  EXPECT_EQ(left(), 9) << "by the token of a login";
  serve_with_key(30);
  EXPECT_EQ(SocketClient(port(), {{"X-Api-Key", "wrong"}}).status(), 101);
  EXPECT_EQ(left(), 9) << "by a handshake";
  for (const auto& [method, params] :
       {std::pair<const char*, Json>{"server.connection.identify", identity_with("wrong")},
        {"access.login", {{"username", "me"}, {"password", "wrong"}}},
        {"access.refresh_jwt", {{"refresh_token", "wrong"}}}}) {
    serve_with_key(30);
    SocketClient client(port());
    EXPECT_EQ(client.call(method, params).at("error").at("code"), 401);
    EXPECT_EQ(left(), 8) << "handshake, message and " << method;
  }
  serve_with_key(30);
  EXPECT_EQ(http().Get("/server/info")->status, 401);
  EXPECT_EQ(left(), 29) << "who has given none has tried none";
}

TEST_F(LimitTest, a_client_without_the_key_sends_no_lists_of_keys_nor_long_messages) {
  serve_with_key(400);
  SocketClient client(port());
  client.send("[" + request("server.connection.identify", identity_with("wrong"), 1) + "," +
              request("server.connection.identify", identity_with(key), 2) + "]");
  const auto answer = client.receive();
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->at("error").at("code"), 401);
  EXPECT_EQ(client.call("server.info").at("error").at("code"), 401) << "nor was it let in by it";
  client.send(std::string(10 * 1024, ' '));
  EXPECT_EQ(client.end(), 1009);
}

TEST_F(LimitTest, what_follows_the_key_at_once_is_that_of_a_client_with_it) {
  serve_with_key(400);
  SocketClient client(port());
  const Json item{{"namespace", "n"}, {"key", "k"}, {"value", std::string(100 * 1024, 'x')}};
  client.send(request("server.connection.identify", identity_with(key), 1));
  client.send(request("server.database.post_item", item, 2));
  for (int id = 1; id <= 2; ++id) {
    auto answer = client.receive();
    while (answer && !answer->contains("id")) answer = client.receive();
    ASSERT_TRUE(answer);
    EXPECT_TRUE(answer->contains("result")) << *answer;
    EXPECT_EQ(answer->at("id"), id);
  }
}

TEST_F(LimitTest, a_client_without_the_key_is_dropped_when_it_asks_too_much) {
  serve_with_key(5);
  SocketClient client(port());
  for (int i = 0; i < 10; ++i) client.send(request("server.info", Json::object(), i));
  EXPECT_TRUE(client.end());
  EXPECT_EQ(http().Get("/access/info")->status, 429);
}

TEST_F(LimitTest, clients_without_the_key_push_out_their_own_ones) {
  serve({.rules = {.key = key, .names = {}},
         .sockets = {.stranger_life = 1h},
         .hub = {.connections = 10, .strangers = 2}});
  SocketClient first(port()), second(port()), third(port());
  EXPECT_EQ(third.status(), 101);
  EXPECT_TRUE(first.end());
  EXPECT_TRUE(third.call("access.info").contains("result"));
}

// What a hub sees of a WebSocket.
struct Stranger final : moonraker::Connection {
  Stranger(std::int64_t number, const std::string& address) : Connection(number, address, false) {}
  void send(Text) override {}
  void push_out() override { is_pushed_out = true; }
  bool is_pushed_out = false;
};

TEST(Hub, keeps_the_strangers_of_one_client_though_another_one_has_many) {
  moonraker::Hub hub({.connections = 10, .strangers = 4});
  std::vector<std::shared_ptr<Stranger>> all;
  const auto enter = [&](const std::string& address) {
    all.push_back(std::make_shared<Stranger>(hub.next_number(), address));
    EXPECT_TRUE(hub.enter(all.back()));
    return all.back();
  };
  const auto quiet = enter("192.0.2.1");
  for (int i = 0; i < 20; ++i) {
    enter("2001:db8::" + std::to_string(i + 1));  // one network
  }
  EXPECT_FALSE(quiet->is_pushed_out);
  EXPECT_TRUE(all[1]->is_pushed_out);
  EXPECT_FALSE(all.back()->is_pushed_out);
  EXPECT_EQ(hub.size(), 4u);
  all.back()->authorise();
  enter("2001:db8::99");
  EXPECT_EQ(hub.size(), 5u) << "with the key it is no stranger";
}

TEST_F(LimitTest, emergency_stops_have_a_limit_of_their_own) {
  serve({.rules = {.key = {},
                   .names = {},
                   .rate = {.burst = 400, .per_second = 0},
                   .stop_rate = {.burst = 3, .per_second = 0}}});
  expect_ready();
  SocketClient client = front_end();
  for (int i = 0; i < 2; ++i) {
    const Json answer = client.call("printer.emergency_stop");
    EXPECT_TRUE(answer.contains("result") || answer.at("error").at("code") != too_busy) << answer;
  }
  EXPECT_EQ(http().Post("/printer/emergency_stop", "{}", "application/json")->status, 200);
  EXPECT_EQ(client.call("printer.emergency_stop").at("error").at("code"), too_busy);
  EXPECT_EQ(http().Post("/printer/emergency_stop", "{}", "application/json")->status, 429);
  EXPECT_EQ(http().Get("/server/info")->status, 200) << "which others do not use up";
}

TEST_F(LimitTest, stops_that_are_not_answered_pile_up_to_a_limit) {
  serve({.sockets = {.stops_in_flight = 2}});
  expect_ready();
  signal_feeder(SIGSTOP);
  SocketClient client = front_end();
  for (int i = 0; i < 6; ++i) {
    client.send(request("printer.emergency_stop", Json::object(), 100 + i));
  }
  EXPECT_EQ(refused_of(client, 4), 4);
  signal_feeder(SIGCONT);
}

TEST_F(LimitTest, bytes_of_requests_that_are_not_answered_pile_up_to_a_limit) {
  serve({.sockets = {.bytes_in_flight = 2000}});
  expect_ready();
  SocketClient client = front_end();
  signal_feeder(SIGSTOP);
  const std::string script = "M105 ;" + std::string(800, 'x');
  for (int i = 0; i < 5; ++i) {
    client.send(request("printer.gcode.script", {{"script", script}}, 100 + i));
  }
  EXPECT_EQ(refused_of(client, 3), 3);
  signal_feeder(SIGCONT);
}

TEST_F(LimitTest, clients_that_do_not_read_their_answer_keep_no_one_out) {
  const auto folder = folder_.path() / "frontend";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "index.html") << "the index";
  std::ofstream(folder / "app.js") << "the script";
  std::filesystem::resize_file(folder / "app.js", 64 * 1024 * 1024);
  serve({.rules = {.key = key, .names = {}}, .frontend = folder, .wait = {.patience = 1h}});
  std::vector<std::unique_ptr<RawClient>> lazy;
  for (int i = 0; i < 60; ++i) {
    lazy.push_back(std::make_unique<RawClient>(port()));
    lazy.back()->say("GET /app.js HTTP/1.1\r\nHost: localhost\r\n\r\n");
  }
  for (const auto& each : lazy) expect_soon([&] { return each->hears(); }, "one has no answer");
  httplib::Client client = http();
  client.set_read_timeout(60s);
  const auto answer = client.Get("/server/info", {{"X-Api-Key", key}});
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 200);
}

}  // namespace
