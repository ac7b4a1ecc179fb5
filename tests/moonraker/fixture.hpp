// SPDX-License-Identifier: Apache-2.0
// A spooler with the Moonraker of its left printer.
#pragma once

#include <memory>
#include <string>

#include "host/moonraker/server.hpp"
#include "tests/host/spooler_fixture.hpp"
#include "tests/moonraker/socket_client.hpp"

namespace moonraker_test {

class MoonrakerTest : public host_test::SpoolerTest {
 protected:
  MoonrakerTest() { serve({}); }
  ~MoonrakerTest() override { server_.reset(); }

  // Address and printer are given here.
  void serve(moonraker::Options options) {
    server_.reset();
    options.printer = "left";
    options.address = {.host = "127.0.0.1", .port = 0};
    server_ = std::make_unique<moonraker::Server>(spool(), settings_, options);
  }
  int port() const { return server_->address().port; }
  httplib::Client http() const { return httplib::Client("127.0.0.1", port()); }

  // A client that has said who it is.
  SocketClient front_end() const {
    SocketClient client(port());
    const Json answer = client.call("server.connection.identify", identity());
    EXPECT_TRUE(answer.contains("result")) << answer;
    return client;
  }
  static Json identity() {
    return {{"client_name", "test"}, {"version", "1"}, {"type", "web"}, {"url", "http://x/"}};
  }
  // Waits until the printer's port is open and it answers.
  void expect_ready() {
    expect_soon([this] { return printer_state().value("link", "") == "ready"; }, "not ready");
  }
  Json status_of(SocketClient& client, const std::string& object) {
    const Json answer = client.call("printer.objects.query", {{"objects", {{object, nullptr}}}});
    return answer.at("result").at("status").at(object);
  }
  // The status of an upload.
  int upload_over_http(const std::string& text, const std::string& name = "part.gcode",
                       const httplib::MultipartFormDataItems& fields = {}) {
    auto items = fields;
    items.push_back({.name = "file",
                     .content = text,
                     .filename = name,
                     .content_type = "application/octet-stream"});
    const auto answer = http().Post("/server/files/upload", items);
    return answer ? answer->status : 0;
  }
  static httplib::MultipartFormData field(const std::string& name, const std::string& value) {
    return {.name = name, .content = value, .filename = "", .content_type = ""};
  }

 private:
  moonraker::SettingsStore settings_{folder_.path() / "front_ends.db"};
  std::unique_ptr<moonraker::Server> server_;
};

}  // namespace moonraker_test
