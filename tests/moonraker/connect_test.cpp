// SPDX-License-Identifier: Apache-2.0
// What front ends ask when they connect, JSON-RPC's rules, and subscriptions.
#include <gmock/gmock.h>

#include <algorithm>

#include "tests/moonraker/fixture.hpp"

namespace {

using namespace std::chrono_literals;
using moonraker_test::Json;
using moonraker_test::MoonrakerTest;
using moonraker_test::SocketClient;
using testing::Contains;

using ConnectTest = MoonrakerTest;

TEST_F(ConnectTest, a_front_end_connects_and_sees_the_printer) {
  expect_ready();
  SocketClient client(port());
  const Json identified = client.call("server.connection.identify", identity());
  EXPECT_GT(identified.at("result").at("connection_id"), 0);
  const Json server = client.call("server.info").at("result");
  EXPECT_EQ(server.at("klippy_connected"), true);
  EXPECT_EQ(server.at("klippy_state"), "ready");
  EXPECT_EQ(server.at("websocket_count"), 1);
  EXPECT_TRUE(server.contains("moonraker_version"));
  EXPECT_EQ(client.call("printer.info").at("result").at("state"), "ready");
  const Json names = client.call("printer.objects.list").at("result").at("objects");
  for (const char* name :
       {"webhooks", "configfile", "print_stats", "virtual_sdcard", "pause_resume", "toolhead",
        "motion_report", "gcode_move", "heaters", "extruder", "heater_bed", "display_status",
        "idle_timeout", "gcode_macro PAUSE", "gcode_macro RESUME", "gcode_macro CANCEL_PRINT"}) {
    EXPECT_THAT(names, Contains(name));
  }
  for (const char* method : {"server.config",
                             "machine.system_info",
                             "machine.proc_stats",
                             "machine.update.status",
                             "server.database.list",
                             "server.files.list",
                             "server.files.roots",
                             "server.webcams.list",
                             "server.gcode_store",
                             "server.temperature_store",
                             "printer.gcode.help",
                             "access.info",
                             "access.get_user",
                             "access.users.list",
                             "server.history.list",
                             "server.history.totals",
                             "server.job_queue.status",
                             "server.announcements.list",
                             "machine.device_power.devices",
                             "server.websocket.id"}) {
    EXPECT_TRUE(client.call(method).contains("result")) << method;
  }
  const Json folder =
      client.call("server.files.get_directory", {{"path", "gcodes"}, {"extended", true}})
          .at("result");
  EXPECT_GT(folder.at("disk_usage").at("free"), 0);
  EXPECT_EQ(client.call("server.files.get_directory", {{"path", "config"}}).at("error").at("code"),
            404);
}

TEST_F(ConnectTest, requests_that_are_none_have_the_errors_of_json_rpc) {
  SocketClient client = front_end();
  const auto code_of = [&client](const std::string& text) {
    client.send(text);
    while (const auto answer = client.receive()) {
      if (answer->contains("error")) return answer->at("error").at("code").get<int>();
    }
    return 0;
  };
  EXPECT_EQ(code_of("{"), -32700);
  EXPECT_EQ(code_of(""), -32700);
  EXPECT_EQ(code_of(std::string(100'000, '[')), -32700) << "nested too deep";
  EXPECT_EQ(code_of("5"), -32600);
  EXPECT_EQ(code_of("[]"), -32600);
  EXPECT_EQ(code_of(R"({"method":"server.info","id":1})"), -32600) << "of another version";
  EXPECT_EQ(code_of(R"({"jsonrpc":"2.0","id":1})"), -32600);
  EXPECT_EQ(code_of(R"({"jsonrpc":"2.0","method":5,"id":1})"), -32600);
  EXPECT_EQ(code_of(R"({"jsonrpc":"2.0","method":"server.info","id":{}})"), -32600);
  EXPECT_EQ(client.call("server.explode").at("error").at("code"), -32601);
  EXPECT_EQ(client.call("server.info", Json::array({1})).at("error").at("code"), -32602);
  EXPECT_EQ(client.call("printer.gcode.script", {{"script", 5}}).at("error").at("code"), -32602);
  EXPECT_EQ(client.call("server.history.list", {{"limit", "many"}}).at("error").at("code"), -32602);
  EXPECT_EQ(client.call("server.database.get_item", {{"namespace", 5}}).at("error").at("code"),
            -32602);
}

TEST_F(ConnectTest, a_batch_has_one_answer_and_a_request_without_id_none) {
  SocketClient client = front_end();
  client.send(R"({"jsonrpc":"2.0","method":"server.info"})");
  client.send(R"({"jsonrpc":"2.0","method":"server.explode"})");
  client.send(R"([{"jsonrpc":"2.0","method":"server.info","id":"a"},
                  {"jsonrpc":"2.0","method":"server.info"},
                  {"jsonrpc":"2.0","method":"server.explode","id":"b"}])");
  Json answer;
  while (const auto message = client.receive()) {
    if (message->is_object() && message->contains("method")) {
      continue;  // a notification
    }
    answer = *message;
    break;
  }
  ASSERT_TRUE(answer.is_array()) << answer;
  ASSERT_EQ(answer.size(), 2u);
  EXPECT_EQ(answer.at(0).at("id"), "a");
  EXPECT_EQ(answer.at(1).at("error").at("code"), -32601);
}

TEST_F(ConnectTest, a_subscription_is_answered_whole_and_then_with_differences) {
  expect_ready();
  SocketClient client = front_end();
  const Json asked{
      {"print_stats", {"state", "message"}}, {"webhooks", nullptr}, {"laser", nullptr}};
  const Json answer = client.call("printer.objects.subscribe", {{"objects", asked}}).at("result");
  EXPECT_GT(answer.at("eventtime"), 0);
  Json known = answer.at("status");
  EXPECT_EQ(known.at("print_stats"), (Json{{"state", "standby"}, {"message", ""}}));
  EXPECT_EQ(known.at("webhooks").at("state"), "ready");
  EXPECT_FALSE(known.contains("laser"));
  const auto follow = [&] {
    const Json changes = client.notified("notify_status_update").value();
    EXPECT_GT(changes.at(1), answer.at("eventtime"));
    for (const auto& [name, object] : changes.at(0).items()) {
      ASSERT_TRUE(asked.contains(name)) << name << " was not asked for";
      for (const auto& [field, value] : object.items()) {
        EXPECT_NE(known[name][field], value) << field << " was known";
        known[name][field] = value;
      }
    }
  };
  upload("G28 X\n", "part.gcode");
  expect_state(1, queue::JobState::queued);
  while (known["print_stats"]["message"].get<std::string>().find("BED_CLEAR") ==
         std::string::npos) {
    follow();
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_EQ(client.call("printer.gcode.script", {{"script", "BED_CLEAR"}}).at("result"), "ok");
  while (known["print_stats"]["state"] != "complete") {
    follow();
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_EQ(known.at("print_stats"), client.call("printer.objects.query", {{"objects", asked}})
                                         .at("result")
                                         .at("status")
                                         .at("print_stats"));
  client.call("printer.objects.subscribe", {{"objects", Json::object()}});
  spool().set_bed_clear("left", true);
  EXPECT_FALSE(client.notified("notify_status_update", 1500ms)) << "nothing is asked any more";
}

TEST_F(ConnectTest, a_front_end_hears_what_the_printer_says_and_that_it_goes) {
  expect_ready();
  SocketClient client = front_end();
  client.call("printer.gcode.script", {{"script", "M117 hello"}});
  left.with([](host_test::LinkPrinter& printer) { printer.say("hello there"); });
  Json said;
  while (said.empty() || said.at(0) != "hello there") {
    const auto next = client.notified("notify_gcode_response");
    ASSERT_TRUE(next) << "it was not sent";
    said = *next;
    EXPECT_NE(said.at(0), "> M117 hello");
  }
  const Json store =
      client.call("server.gcode_store", {{"count", 50}}).at("result").at("gcode_store");
  const auto has = [&store](const std::string& text, const std::string& type) {
    return std::ranges::any_of(store, [&](const Json& line) {
      return line.at("message") == text && line.at("type") == type && line.at("time") > 1e9;
    });
  };
  EXPECT_TRUE(has("M117 hello", "command"));
  EXPECT_TRUE(has("hello there", "response"));
  left.unplug();
  EXPECT_TRUE(client.notified("notify_klippy_disconnected"));
  EXPECT_NE(status_of(client, "webhooks").at("state"), "ready");
  left.plug_in();
  EXPECT_TRUE(client.notified("notify_klippy_ready"));
  EXPECT_TRUE(client.notified("notify_proc_stat_update"));
}

TEST_F(ConnectTest, an_emergency_stop_is_obeyed_and_shown) {
  expect_ready();
  begin_print(2000, 20);
  SocketClient client = front_end();
  EXPECT_EQ(client.call("printer.emergency_stop").at("result"), "ok");
  expect_state(1, queue::JobState::failed);
  EXPECT_TRUE(client.notified("notify_klippy_shutdown"));
  EXPECT_EQ(client.call("server.info").at("result").at("klippy_state"), "shutdown");
  const Json stats = status_of(client, "print_stats");
  EXPECT_EQ(stats.at("state"), "error");
  EXPECT_THAT(stats.at("message").get<std::string>(), testing::HasSubstr("emergency stop"));
  EXPECT_EQ(client.call("server.history.list").at("result").at("jobs").at(0).at("status"), "error");
}

}  // namespace
