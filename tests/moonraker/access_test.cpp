// SPDX-License-Identifier: Apache-2.0
// Keys, tokens, names and origins, over HTTP and at the handshake; files of a front end.
#include <gmock/gmock.h>

#include <fstream>

#include "tests/moonraker/fixture.hpp"

namespace {

using namespace std::chrono_literals;
using moonraker_test::Json;
using moonraker_test::MoonrakerTest;
using moonraker_test::SocketClient;

const std::string key = "a_key_of_16_or_more_characters";

class KeyTest : public MoonrakerTest {
 protected:
  KeyTest() { serve({.rules = {.key = key, .names = {}}}); }

  int got(const std::string& path, const httplib::Headers& headers = {}) const {
    const auto answer = http().Get(path, headers);
    return answer ? answer->status : 0;
  }
  int posted(const std::string& path, const httplib::Headers& headers = {}) const {
    const auto answer = http().Post(path, headers, "{}", "application/json");
    return answer ? answer->status : 0;
  }
};

TEST_F(KeyTest, nothing_of_the_api_is_answered_without_the_key) {
  EXPECT_EQ(got("/server/info"), 401);
  EXPECT_EQ(got("/server/info", {{"X-Api-Key", "wrong"}}), 401);
  EXPECT_EQ(got("/server/info", {{"X-Api-Key", ""}}), 401);
  EXPECT_EQ(got("/server/info?token=wrong"), 401);
  EXPECT_EQ(got("/server/files/gcodes/a.gcode"), 401);
  EXPECT_EQ(got("/api/version"), 401);
  EXPECT_EQ(got("/access/oneshot_token"), 401);
  EXPECT_EQ(posted("/printer/emergency_stop"), 401);
  EXPECT_EQ(upload_over_http("G28\n"), 401);
  EXPECT_EQ(got("/server/info", {{"X-Api-Key", key}}), 200);
  EXPECT_EQ(got("/server/info", {{"Authorization", "Bearer " + key}}), 200);
  EXPECT_EQ(got("/access/info"), 200) << "it says that a login is needed";
}

TEST_F(KeyTest, a_login_over_http_has_a_token) {
  const auto log_in = [this](const std::string& password) {
    const Json body{{"username", "me"}, {"password", password}};
    return http().Post("/access/login", body.dump(), "application/json");
  };
  EXPECT_EQ(log_in("wrong")->status, 401);
  const auto answer = log_in(key);
  ASSERT_EQ(answer->status, 200);
  const std::string token = Json::parse(answer->body).at("result").at("token");
  EXPECT_NE(token, key);
  EXPECT_EQ(got("/server/info", {{"Authorization", "Bearer " + token}}), 200);
}

TEST_F(KeyTest, a_oneshot_token_is_good_for_one_request) {
  const auto token = [this] {
    const auto answer = http().Get("/access/oneshot_token", {{"X-Api-Key", key}});
    return Json::parse(answer->body).at("result").get<std::string>();
  };
  const std::string first = token();
  EXPECT_EQ(got("/server/info?token=" + first), 200);
  EXPECT_EQ(got("/server/info?token=" + first), 401);
  const std::string second = token();
  SocketClient client(port(), {}, "/websocket?token=" + second);
  EXPECT_TRUE(client.call("server.info").contains("result"));
  SocketClient again(port(), {}, "/websocket?token=" + second);
  EXPECT_EQ(again.call("server.info").at("error").at("code"), 401);
}

TEST_F(KeyTest, a_websocket_without_the_key_can_only_give_it) {
  expect_ready();
  SocketClient client(port());
  EXPECT_EQ(client.call("server.info").at("error").at("code"), 401);
  EXPECT_EQ(client.call("printer.emergency_stop").at("error").at("code"), 401);
  EXPECT_EQ(client.call("server.connection.identify", identity()).at("error").at("code"), 401);
  Json wrong = identity();
  wrong["api_key"] = "wrong";
  EXPECT_EQ(client.call("server.connection.identify", wrong).at("error").at("code"), 401);
  EXPECT_FALSE(client.notified("notify_proc_stat_update", 1500ms)) << "nor does it hear anything";
  Json with_key = identity();
  with_key["api_key"] = key;
  EXPECT_TRUE(client.call("server.connection.identify", with_key).contains("result"));
  EXPECT_TRUE(client.call("server.info").contains("result"));
  EXPECT_TRUE(client.notified("notify_proc_stat_update"));
  SocketClient other(port());
  EXPECT_TRUE(
      other.call("access.login", {{"username", "me"}, {"password", key}}).contains("result"));
  EXPECT_TRUE(other.call("server.info").contains("result"));
  SocketClient with_header(port(), {{"X-Api-Key", key}});
  EXPECT_TRUE(with_header.call("server.info").contains("result"));
}

TEST_F(KeyTest, who_does_not_give_the_key_is_dropped_and_keeps_no_one_out) {
  serve({.rules = {.key = key, .names = {}},
         .sockets = {.stranger_life = 500ms},
         .hub = {.connections = 10, .strangers = 2}});
  SocketClient first(port()), second(port());
  SocketClient friendly(port(), {{"X-Api-Key", key}});
  EXPECT_EQ(friendly.status(), 101);
  EXPECT_TRUE(first.end()) << "it had half a second";
  EXPECT_TRUE(second.end());
  EXPECT_TRUE(friendly.call("server.info").contains("result"));
}

TEST_F(MoonrakerTest, who_asks_too_much_must_wait_but_may_stop_the_printer) {
  serve({.rules = {.key = {}, .names = {}, .rate = {.burst = 3, .per_second = 0}}});
  expect_ready();
  for (int i = 0; i < 3; ++i) EXPECT_EQ(http().Get("/server/info")->status, 200);
  const auto refused = http().Get("/server/info");
  EXPECT_EQ(refused->status, 429);
  EXPECT_EQ(refused->get_header_value("Retry-After"), "1");
  EXPECT_EQ(SocketClient(port()).status(), 429);
  EXPECT_EQ(http().Post("/printer/emergency_stop", "{}", "application/json")->status, 200);
}

TEST_F(MoonrakerTest, other_sites_and_names_open_no_websocket_and_change_nothing) {
  const std::string own = "127.0.0.1:" + std::to_string(port());
  EXPECT_EQ(SocketClient(port()).status(), 101);
  EXPECT_EQ(SocketClient(port(), {{"Origin", "http://" + own}}).status(), 101);
  EXPECT_EQ(SocketClient(port(), {{"Origin", "http://evil.example"}}).status(), 403);
  EXPECT_EQ(SocketClient(port(), {{"Origin", "null"}}).status(), 403);
  EXPECT_EQ(SocketClient(port(), {{"Sec-Fetch-Site", "cross-site"}}).status(), 403);
  EXPECT_EQ(SocketClient(port(), {{"Host", "evil.example"}}).status(), 403) << "DNS rebinding";
  EXPECT_EQ(SocketClient(port(), {}, "/elsewhere").status(), 404);
  const auto stop = http().Post("/printer/emergency_stop", {{"Origin", "http://evil.example"}},
                                "{}", "application/json");
  EXPECT_EQ(stop->status, 403);
  EXPECT_EQ(http().Get("/server/info", {{"Host", "evil.example"}})->status, 403);
}

TEST_F(MoonrakerTest, a_lan_needs_a_key_and_a_folder_an_index) {
  moonraker::SettingsStore settings(folder_.path() / "other.db");
  moonraker::Options options{.printer = "left", .address = {.host = "0.0.0.0", .port = 0}};
  EXPECT_THROW(moonraker::Server(spool(), settings, options), std::runtime_error);
  options.address.host = "127.0.0.1";
  options.frontend = folder_.path() / "nothing";
  EXPECT_THROW(moonraker::Server(spool(), settings, options), std::runtime_error);
  options.frontend.clear();
  options.printer = "middle";
  EXPECT_THROW(moonraker::Server(spool(), settings, options), spooler::NoSuchPrinter);
}

TEST_F(MoonrakerTest, the_files_of_a_front_end_are_served_and_no_others) {
  const auto frontend = folder_.path() / "frontend";
  std::filesystem::create_directories(frontend / "assets");
  std::ofstream(frontend / "index.html") << "the index";
  std::ofstream(frontend / "assets" / "app.js") << "the script";
  std::ofstream(folder_.path() / "secret.txt") << "secret";
  serve({.rules = {.key = key, .names = {}}, .frontend = frontend});
  const auto text = [this](const std::string& path) {
    const auto answer = http().Get(path);
    return answer ? std::to_string(answer->status) + " " + answer->body : "";
  };
  EXPECT_EQ(text("/"), "200 the index") << "without the key";
  EXPECT_EQ(text("/console"), "200 the index");
  EXPECT_EQ(text("/assets/app.js"), "200 the script");
  EXPECT_THAT(text("/assets/none.js"), testing::StartsWith("404"));
  for (const char* path : {"/../secret.txt", "/assets/../../secret.txt", "/%2e%2e/secret.txt",
                           "/..%2fsecret.txt", "/assets/..%2f..%2fsecret.txt"}) {
    EXPECT_THAT(text(path), testing::Not(testing::HasSubstr("secret"))) << path;
  }
}

}  // namespace
