// SPDX-License-Identifier: Apache-2.0
// Broken frames, long messages, many connections, and clients that do not read.
#include <gmock/gmock.h>
#include <signal.h>

#include <chrono>

#include "tests/host/raw_client.hpp"
#include "tests/moonraker/fixture.hpp"

namespace {

using namespace std::chrono_literals;
using host_test::RawClient;
using moonraker_test::Json;
using moonraker_test::MoonrakerTest;
using moonraker_test::SocketClient;
using testing::HasSubstr;
using testing::StartsWith;

using SocketTest = MoonrakerTest;

const std::string handshake =
    "GET /websocket HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
    "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n";

void wait_for_answer(const RawClient& client) {
  for (int i = 0; i < 3000 && !client.hears(); ++i) std::this_thread::sleep_for(10ms);
}

TEST_F(SocketTest, the_handshake_is_that_of_rfc_6455) {
  const RawClient client(port());
  client.say(handshake);
  wait_for_answer(client);
  client.say(std::string("\x88\x80\x00\x00\x00\x00", 6));  // close, masked
  const std::string answer = client.all();
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 101 "));
  EXPECT_THAT(answer, HasSubstr("s3pPLMBiTxaQ9kYGzzhZRbK+xOo=")) << "RFC 6455, 1.3";
}

TEST_F(SocketTest, what_is_no_handshake_is_refused) {
  const auto answer = [this](std::string head, const std::string& what, const std::string& by) {
    head.replace(head.find(what), what.size(), by);
    return host_test::raw(port(), head);
  };
  EXPECT_THAT(answer(handshake, "Version: 13", "Version: 8"), HasSubstr(" 426 "));
  EXPECT_THAT(answer(handshake, "Sec-WebSocket-Key", "X-Key"), HasSubstr(" 400 "));
  EXPECT_THAT(answer(handshake, "HTTP/1.1", "HTTP/1.0"), HasSubstr(" 400 "));
  EXPECT_THAT(answer(handshake, "Upgrade: websocket", "Upgrade: h2c"), HasSubstr(" 404 "));
  EXPECT_THAT(answer(handshake, "Host: localhost", "Host: a\r\nHost: b"), HasSubstr(" 400 "));
}

TEST_F(SocketTest, broken_frames_end_their_connection_and_no_other) {
  SocketClient client = front_end();
  const std::vector<std::string> broken{
      std::string("\x81\x02{}", 4),  // not masked
      std::string("\xf1\x80\x00\x00\x00\x00", 6),  // reserved bits
      std::string("\x83\x80\x00\x00\x00\x00", 6),  // reserved operation
      std::string("\x80\x80\x00\x00\x00\x00", 6),  // goes on with nothing
      std::string("\x09\x80\x00\x00\x00\x00", 6),  // a ping in parts
      std::string("\x89\xfe\x00\x80\x00\x00\x00\x00", 8),  // a ping of 128 bytes
      std::string("\x81\xff\xff\xff\xff\xff\xff\xff\xff\xff\x00\x00\x00\x00",
                  14),  // 2^64 - 1 bytes
      std::string("\x81\xff\x00\x00\x00\x00\x40\x00\x00\x00\x00\x00\x00\x00", 14),  // 1 GiB
      std::string("\x81\x82\x00\x00\x00\x00\xff\xff", 8)};  // no UTF-8
  for (const std::string& frame : broken) {
    const RawClient raw(port());
    raw.say(handshake);
    wait_for_answer(raw);
    raw.say(frame);
    EXPECT_THAT(raw.all(), StartsWith("HTTP/1.1 101 ")) << "and then its end";
  }
  EXPECT_TRUE(client.call("server.info").contains("result"));
  expect_soon([&] { return client.call("server.info").at("result").at("websocket_count") == 1; },
              "ended connections are counted");
}

TEST_F(SocketTest, random_bytes_harm_no_one) {
  SocketClient client = front_end();
  std::uint32_t state = 12345;
  for (int i = 0; i < 200; ++i) {
    const RawClient raw(port());
    raw.say(handshake);
    std::string bytes;
    for (int n = 0; n < 64; ++n) {
      state = state * 1664525 + 1013904223;
      bytes += static_cast<char>(state >> 24u);
    }
    raw.say(bytes);
  }
  EXPECT_TRUE(client.call("server.info").contains("result"));
  expect_soon([&] { return client.call("server.info").at("result").at("websocket_count") == 1; },
              "ended connections are counted");
}

TEST_F(SocketTest, a_message_that_is_too_long_or_no_text_ends_the_connection) {
  SocketClient client = front_end();
  client.send(std::string(300 * 1024, ' '));
  EXPECT_EQ(client.end(), 1009);
  SocketClient binary = front_end();
  binary.send(R"({"jsonrpc":"2.0","method":"server.info","id":1})", false);
  EXPECT_EQ(binary.end(), 1003);
  SocketClient other = front_end();
  const Json value = std::string(200 * 1024, 'x');
  EXPECT_TRUE(
      other.call("server.database.post_item", {{"namespace", "n"}, {"key", "k"}, {"value", value}})
          .contains("result"));
}

TEST_F(SocketTest, a_hundred_front_ends_hear_the_same) {
  serve({.sockets = {.idle = 10min}});  // the first ones read nothing until the last one is there
  expect_ready();
  std::vector<SocketClient> clients;
  for (int i = 0; i < 100; ++i) {
    clients.push_back(front_end());
    clients.back().call("printer.objects.subscribe", {{"objects", {{"print_stats", nullptr}}}});
  }
  upload("G28 X\n", "part.gcode");
  for (SocketClient& client : clients) {
    EXPECT_TRUE(client.notified("notify_filelist_changed"));
    EXPECT_TRUE(client.notified("notify_status_update"));
  }
  EXPECT_EQ(clients.front().call("server.info").at("result").at("websocket_count"), 100);
}

TEST_F(SocketTest, one_too_many_is_refused_until_one_goes) {
  serve({.hub = {.connections = 3, .strangers = 3}});
  std::vector<SocketClient> clients;
  for (int i = 0; i < 3; ++i) clients.push_back(front_end());
  EXPECT_EQ(SocketClient(port()).status(), 503);
  EXPECT_TRUE(http().Get("/server/info")) << "HTTP has its own limits";
  clients.back().close();
  expect_soon([this] { return SocketClient(port()).status() == 101; }, "no place became free");
}

TEST_F(SocketTest, a_client_that_does_not_read_is_dropped_and_delays_no_one) {
  serve({.sockets = {.output = 64 * 1024, .in_flight = 1'000'000}});
  SocketClient lazy = front_end(), other = front_end();
  const std::string request = Json{{"jsonrpc", "2.0"},
                                   {"method", "printer.objects.query"},
                                   {"params", {{"objects", {{"configfile", nullptr}}}}},
                                   {"id", 1}}
                                  .dump();
  bool dropped = false;
  for (int i = 0; i < 200'000 && !dropped; ++i) {
    lazy.send(request);
    if (i % 500 == 0) dropped = other.call("server.info").at("result").at("websocket_count") == 1;
  }
  EXPECT_TRUE(dropped) << "its answers have gone on piling up";
  EXPECT_TRUE(other.notified("notify_proc_stat_update"));
}

TEST_F(SocketTest, requests_beyond_the_limit_are_refused_but_not_an_emergency_stop) {
  serve({.sockets = {.in_flight = 2}});
  expect_ready();
  signal_feeder(SIGSTOP);  // each request waits for its answer, which does not come
  SocketClient client = front_end();
  for (int id = 100; id < 105; ++id) {
    client.send(Json{
        {"jsonrpc", "2.0"},
        {"method", "printer.gcode.script"},
        {"params", {{"script", "M105"}}},
        {"id", id}}.dump());
  }
  int refused = 0;
  while (refused < 3) {
    const auto message = client.receive();
    ASSERT_TRUE(message);
    if (message->contains("error")) {
      EXPECT_EQ(message->at("error").at("code"), -32000);
      EXPECT_GE(message->at("id"), 102);
      ++refused;
    }
  }
  client.send(R"({"jsonrpc":"2.0","method":"printer.emergency_stop","id":7})");
  signal_feeder(SIGCONT);
  expect_soon(
      [this] {
        const Json printer = printer_state();
        for (const Json& line : printer.at("console")) {
          if (line.at("text") == "> M112") return true;
        }
        return false;
      },
      "the emergency stop has not come through");
}

TEST_F(SocketTest, a_front_end_comes_again_without_its_subscription) {
  SocketClient first = front_end();
  first.call("printer.objects.subscribe", {{"objects", {{"print_stats", nullptr}}}});
  first.close();
  SocketClient second = front_end();
  upload("G28 X\n", "part.gcode");
  EXPECT_TRUE(second.notified("notify_filelist_changed"));
  EXPECT_FALSE(second.notified("notify_status_update", 1s)) << "the subscription was the other's";
  serve({});
  EXPECT_TRUE(second.end()) << "the server has ended";
  EXPECT_TRUE(front_end().call("server.info").contains("result"));
}

}  // namespace
