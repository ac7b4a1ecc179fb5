// SPDX-License-Identifier: Apache-2.0
// The description of the API (OpenAPI) has the routes of the server and no others, and what the
// server answers is as described.
#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "directories.hpp"
#include "host/web/listener.hpp"
#include "tests/host/json_schema.hpp"
#include "tests/host/web_fixture.hpp"
#include "tools/files/file_text.hpp"

namespace {

using host_test::misfit;
using host_test::WebTest;
using nlohmann::json;
using queue::JobState;

const std::string catch_all = ".*";

// A method at a path without parameters, and what is described for it.
struct Operation {
  std::string method, path;
  json description;
  bool is_twice = false;  // also below a printer's name
};

class OpenApiTest : public WebTest {
 protected:
  json resolved(const json& part) const {
    if (!part.contains("$ref")) return part;
    return api.at(json::json_pointer(part.at("$ref").get<std::string>().substr(1)));
  }
  // The paths of a template: for each parameter its example, or all that it may be.
  std::vector<std::string> filled(const std::string& path, const json& description) const {
    std::vector<std::string> paths{path};
    for (const json& each : description.value("parameters", json::array())) {
      const json parameter = resolved(each);
      if (parameter.at("in") != "path") continue;
      json values = parameter.at("schema").value("enum", json::array());
      if (values.empty()) values.push_back(parameter.at("example"));
      std::vector<std::string> more;
      for (const std::string& one : paths) {
        for (const json& value : values) {
          const std::string name = "{" + parameter.at("name").get<std::string>() + "}";
          const std::size_t at = one.find(name);
          EXPECT_NE(at, std::string::npos) << path << " has no " << name;
          const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
          more.push_back(std::string(one).replace(at, name.size(), text));
        }
      }
      paths = more;
    }
    return paths;
  }
  std::vector<Operation> operations() const {
    std::vector<Operation> all;
    for (const auto& [path, methods] : api.at("paths").items()) {
      for (const auto& [name, description] : methods.items()) {
        std::string method;
        for (const char c : name) method += static_cast<char>(std::toupper(c));
        const json tag = description.at("tags").at(0);
        for (const std::string& one : filled(path, description)) {
          EXPECT_EQ(one.find('{'), std::string::npos) << one << " has an unknown parameter";
          all.push_back({method, one, description, tag == "OctoPrint" || tag == "PrusaLink"});
        }
      }
    }
    return all;
  }
  // The first one that takes it, as httplib looks for it; its number.
  std::size_t route_of(const std::string& method, const std::string& path) const {
    const auto found = std::ranges::find_if(routes(), [&](const web::Route& route) {
      return route.method == method && std::regex_match(path, std::regex(route.pattern));
    });
    return static_cast<std::size_t>(found - routes().begin());
  }
  httplib::Result sent(const Operation& operation) {
    const json bodies =
        operation.description.value("requestBody", json::object()).value("content", json::object());
    if (bodies.contains("multipart/form-data")) {
      return client().Post(operation.path, form("G28 X\n", "b.gcode", "false"));
    }
    std::string type = "application/json", body;
    if (!bodies.empty()) {
      type = bodies.begin().key();
      const json example = bodies.begin().value().at("example");
      body = example.is_string() ? example.get<std::string>() : example.dump();
    }
    if (operation.method == "GET") return client().Get(operation.path);
    if (operation.method == "DELETE") return client().Delete(operation.path);
    if (operation.method == "PUT") return client().Put(operation.path, body, type);
    return client().Post(operation.path, body, type);
  }
  // Sends it; whether the answer is as described. GET must succeed.
  void expect_as_described(const Operation& operation) {
    SCOPED_TRACE(operation.method + " " + operation.path);
    const auto answer = sent(operation);
    ASSERT_TRUE(answer);
    const std::string status = std::to_string(answer->status);
    const json responses = operation.description.at("responses");
    ASSERT_TRUE(responses.contains(status)) << status << " " << answer->body;
    if (operation.method == "GET") {
      EXPECT_LT(answer->status, 300) << answer->body;
    }
    const json content = resolved(responses.at(status)).value("content", json::object());
    if (content.empty()) {
      EXPECT_EQ(answer->body, "");
      return;
    }
    const std::string type = answer->get_header_value("Content-Type");
    const std::string described = content.begin().key();
    EXPECT_EQ(type.substr(0, type.find(';')), described);
    if (described != "application/json") return;
    const json schema = content.begin().value().at("schema");
    EXPECT_EQ(misfit(json::parse(answer->body, nullptr, false), schema, api), "");
  }

  const json api = json::parse(files::text_of(PROJECT_DIRECTORY "/host/web/openapi.json"));
};

TEST_F(OpenApiTest, is_served) { EXPECT_EQ(got("/api/openapi.json"), api); }

TEST_F(OpenApiTest, has_each_route_of_the_server_and_no_other) {
  std::set<std::size_t> described;
  for (const Operation& operation : operations()) {
    const std::size_t route = route_of(operation.method, operation.path);
    ASSERT_LT(route, routes().size()) << operation.method << " " << operation.path;
    EXPECT_NE(routes()[route].pattern, catch_all) << operation.method << " " << operation.path;
    described.insert(route);
    if (operation.is_twice) {
      EXPECT_EQ(route_of(operation.method, "/printers/left" + operation.path), route);
    }
  }
  for (std::size_t i = 0; i < routes().size(); ++i) {
    if (routes()[i].pattern == catch_all) continue;
    EXPECT_TRUE(described.contains(i)) << routes()[i].method << " " << routes()[i].pattern;
  }
}

TEST_F(OpenApiTest, says_what_the_server_answers) {
  expect_soon([&] { return printer_state().at("link") == "ready"; }, "not ready");
  // Job 1 has a path and a picture.
  upload("M83\nG1 Z0.2 F600\nG1 X10 E1\nG1 Z0.4\nG1 X0 E1\n", "a.gcode");
  expect_state(1, JobState::queued);
  std::vector<Operation> all = operations();
  std::erase_if(all, [](const Operation& each) { return each.path == "/api/v1/events"; });
  // What changes nothing first, what ends things last.
  const auto turn = [](const Operation& each) {
    if (each.method == "GET") return 0;
    const bool ends = each.method == "DELETE" || each.path.ends_with("/cancel") ||
                      each.path.ends_with("/stop") || each.path.ends_with("/restart");
    return ends ? 2 : 1;
  };
  std::ranges::stable_sort(all, {}, turn);
  for (const Operation& each : all) expect_as_described(each);
}

}  // namespace
