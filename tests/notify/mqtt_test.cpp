// SPDX-License-Identifier: Apache-2.0
// MQTT with Debian's broker: retained states, last words, restarts, logins.
#include "host/notify/mqtt.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/notify/broker.hpp"

namespace {

using namespace std::chrono_literals;
using notify::Json;
using notify::Kind;
using notify::Mqtt;
using notify::MqttOptions;
using notify_test::Broker;
using notify_test::StrangeServer;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

Json snapshot(int done) {
  return {{"printers",
           {{{"name", "left"},
             {"link", "ready"},
             {"fault", ""},
             {"job", 4},
             {"done", done},
             {"waits_for_user", false},
             {"bed_clear", false},
             {"hotend", {205.1, 205}},
             {"bed", {nullptr, nullptr}}}}},
          {"jobs", {{{"id", 4}, {"name", "part.gcode"}, {"state", "printing"}, {"commands", 50}}}}};
}

class Publishing : public testing::Test {
 protected:
  std::unique_ptr<Mqtt> made(const std::string& address, MqttOptions options = {}) {
    const MqttOptions read = notify::mqtt_options(address, "", "stepfabric");
    options.host = read.host;
    options.port = read.port;
    options.pauses = {.first = 50ms, .longest = 200ms};
    return std::make_unique<Mqtt>(options, [this](const std::string& line) {
      const std::scoped_lock lock(mutex_);
      log_.push_back(line);
    });
  }
  static void take(Mqtt& mqtt, const std::string& id, const std::string& printer = "left") {
    mqtt.take({.kind = Kind::job_finished, .printer = printer, .job = 4, .id = id});
  }
  bool has_said(const std::string& words) {
    for (int i = 0; i < 6000; ++i) {
      {
        const std::scoped_lock lock(mutex_);
        for (const auto& line : log_) {
          if (line.find(words) != std::string::npos) return true;
        }
      }
      std::this_thread::sleep_for(10ms);
    }
    return false;
  }

 private:
  std::mutex mutex_;
  std::vector<std::string> log_;
};

TEST_F(Publishing, the_state_is_retained_and_follows) {
  const Broker broker;
  const auto mqtt = made(broker.address());
  mqtt->show(snapshot(1));
  EXPECT_TRUE(broker.retains("stepfabric/status", "online"));
  ASSERT_TRUE(broker.retains("stepfabric/left/state", R"("done":1,)"));
  EXPECT_EQ(Json::parse(broker.retained("stepfabric/left/state")),
            Json::parse(R"({"state": "printing", "job": 4, "file": "part.gcode", "done": 1,
                            "commands": 50, "link": "ready", "fault": "", "bed_clear": false,
                            "hotend": [205.1, 205], "bed": [null, null]})"));
  mqtt->show(snapshot(2));
  EXPECT_TRUE(broker.retains("stepfabric/left/state", R"("done":2,)"));
}

TEST_F(Publishing, events_come_once_in_order_and_are_not_retained) {
  const Broker broker;
  broker.remember("stepfabric/#");
  const auto mqtt = made(broker.address());
  ASSERT_TRUE(broker.retains("stepfabric/status", "online"));
  for (const char* id : {"1", "2", "3"}) take(*mqtt, id);
  take(*mqtt, "4", "");
  const std::string heard = broker.remembered("stepfabric/#", 5);  // the first: online
  std::vector<std::string> ids;
  std::istringstream lines(heard);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("stepfabric/status")) continue;
    ids.push_back(line.substr(0, line.find(' ')) + " " +
                  Json::parse(line.substr(line.find('{'))).at("id").get<std::string>());
  }
  EXPECT_THAT(ids, ElementsAre("stepfabric/left/event 1", "stepfabric/left/event 2",
                               "stepfabric/left/event 3", "stepfabric/event 4"));
  EXPECT_EQ(broker.retained("stepfabric/left/event"), "");
}

TEST_F(Publishing, an_orderly_end_delivers_what_waits_and_says_offline) {
  const Broker broker;
  broker.remember("stepfabric/left/event");
  auto mqtt = made(broker.address());
  ASSERT_TRUE(broker.retains("stepfabric/status", "online"));
  for (int i = 0; i < 20; ++i) take(*mqtt, std::to_string(i));
  mqtt.reset();
  EXPECT_EQ(broker.retained("stepfabric/status"), "offline");
  EXPECT_THAT(broker.remembered("stepfabric/left/event", 20), HasSubstr(R"("id":"19")"));
}

TEST_F(Publishing, a_broker_that_has_forgotten_everything_gets_all_again) {
  Broker broker;
  const auto mqtt = made(broker.address());
  mqtt->show(snapshot(7));
  ASSERT_TRUE(broker.retains("stepfabric/left/state", R"("done":7,)"));
  broker.end();
  EXPECT_TRUE(has_said("it is tried again"));
  broker.begin();
  EXPECT_TRUE(has_said("connected"));
  EXPECT_TRUE(broker.retains("stepfabric/left/state", R"("done":7,)"));
  EXPECT_TRUE(broker.retains("stepfabric/status", "online"));
}

TEST_F(Publishing, events_wait_for_the_broker_to_return) {
  Broker broker("allow_anonymous true\npersistence true\n");
  broker.remember("stepfabric/left/event");
  const auto mqtt = made(broker.address());
  take(*mqtt, "before");
  ASSERT_TRUE(broker.retains("stepfabric/status", "online"));
  broker.end();
  ASSERT_TRUE(has_said("it is tried again"));
  take(*mqtt, "first");
  take(*mqtt, "second");
  broker.begin();
  const std::string heard = broker.remembered("stepfabric/left/event", 3);
  EXPECT_LT(heard.find("before"), heard.find("first"));
  EXPECT_LT(heard.find("first"), heard.find("second"));
  EXPECT_THAT(heard, HasSubstr("second"));
}

TEST_F(Publishing, a_login_is_needed_where_the_broker_wants_one) {
  const TemporaryFolder folder;
  const std::string users = folder.path() / "users", login = folder.path() / "login";
  ASSERT_EQ(process::capture({.arguments = {"mosquitto_passwd", "-b", "-c", users, "me", "right"}})
                .exit_status,
            0);
  const Broker broker("password_file " + users + "\nallow_anonymous true\n");
  folder.write("login", "me\nright\n");
  EXPECT_THROW(notify::mqtt_options("host", login, "stepfabric"), std::runtime_error)
      << "others can read it";
  std::filesystem::permissions(login, std::filesystem::perms(0600));
  const MqttOptions right = notify::mqtt_options("host", login, "stepfabric");
  MqttOptions wrong = right;
  wrong.password = "wrong";
  {
    const auto mqtt = made(broker.address(), wrong);
    EXPECT_TRUE(has_said("not authorised"));
  }
  EXPECT_EQ(broker.retained("stepfabric/status"), "");
  const auto mqtt = made(broker.address(), right);
  EXPECT_TRUE(broker.retains("stepfabric/status", "online"));
}

// It is dropped after the time of MQTT's keep-alive, and what waits meanwhile is bounded.
TEST_F(Publishing, a_silent_broker_blocks_no_one) {
  const StrangeServer broker("");
  auto mqtt = made("127.0.0.1:" + std::to_string(broker.port()), {.keep_alive = 5s});
  for (int i = 0; i < 10'000; ++i) take(*mqtt, std::to_string(i));
  mqtt->show(snapshot(1));
  EXPECT_TRUE(broker.has_had(2));
}

TEST(MqttOptionsOf, the_command_line_are_read_and_refused) {
  const MqttOptions usual = notify::mqtt_options("broker", "", "a/b");
  EXPECT_EQ(usual.host, "broker");
  EXPECT_EQ(usual.port, 1883);
  EXPECT_EQ(notify::mqtt_options("[::1]:99", "", "a").port, 99);
  for (const char* wrong : {"", "broker:", "broker:0", "broker:x", "broker:65536"}) {
    EXPECT_THROW(notify::mqtt_options(wrong, "", "a"), std::runtime_error) << wrong;
  }
  for (const char* wrong : {"", "/a", "a/", "a//b", "a/#", "+", "$SYS", "a b"}) {
    EXPECT_THROW(notify::mqtt_options("broker", "", wrong), std::runtime_error) << wrong;
  }
  EXPECT_THROW(notify::mqtt_options("broker", "/missing", "a"), std::runtime_error);
}

}  // namespace
