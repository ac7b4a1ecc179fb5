// SPDX-License-Identifier: Apache-2.0
// A spooler with its web server, and clients of it.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "host/web/http.hpp"
#include "host/web/server.hpp"
#include "tests/host/spooler_fixture.hpp"

namespace host_test {

class WebTest : public SpoolerTest {
 protected:
  WebTest() { serve({}); }
  ~WebTest() override { server_.reset(); }

  void serve(const web::Rules& rules, const web::WaitLimits& limits = {}) {
    server_.reset();
    server_ = std::make_unique<web::Server>(spool(), web::Address{.host = "127.0.0.1", .port = 0},
                                            rules, limits);
  }
  httplib::Client client() const { return httplib::Client("127.0.0.1", port()); }
  int port() const { return server_->address().port; }
  const std::vector<web::Route>& routes() const { return server_->routes(); }

  nlohmann::json got(const std::string& path) {
    const auto answer = client().Get(path);
    return answer ? nlohmann::json::parse(answer->body, nullptr, false) : nlohmann::json();
  }
  // The status, or 0 where there was no answer.
  int posted(const std::string& path, const nlohmann::json& body = nlohmann::json::object(),
             const httplib::Headers& headers = {}) {
    const auto answer = client().Post(path, headers, body.dump(), "application/json");
    return answer ? answer->status : 0;
  }
  // As PrusaSlicer and OrcaSlicer do.
  static httplib::MultipartFormDataItems form(const std::string& text,
                                              const std::string& name = "part.gcode",
                                              const std::string& print = "true") {
    return {{.name = "print", .content = print, .filename = "", .content_type = ""},
            {.name = "path", .content = "", .filename = "", .content_type = ""},
            {.name = "file",
             .content = text,
             .filename = name,
             .content_type = "application/octet-stream"}};
  }

 private:
  std::unique_ptr<web::Server> server_;
};

}  // namespace host_test
