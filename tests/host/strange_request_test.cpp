// SPDX-License-Identifier: Apache-2.0
// Requests that can be read in two ways, or are wrong: refused, and the answer says what is wrong.
#include <gmock/gmock.h>

#include "tests/host/raw_client.hpp"
#include "tests/host/web_fixture.hpp"

namespace {

using host_test::raw;
using host_test::WebTest;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string host = "Host: 127.0.0.1\r\n";
const std::string empty_post = "POST /api/login HTTP/1.1\r\n" + host;

TEST_F(WebTest, refuses_headers_that_can_be_read_in_two_ways) {
  serve({.key = "0123456789abcdef", .names = {}});
  const std::string key = "X-Api-Key: 0123456789abcdef\r\n";
  ASSERT_THAT(raw(port(), empty_post + key + "Content-Length: 2\r\n\r\n{}"), HasSubstr(" 200 "));
  for (const std::string& head :
       {"GET / HTTP/1.1\r\nHost: evil.example\r\n" + host + "\r\n",
        "GET / HTTP/1.1\r\n" + host + "Host: evil.example\r\n\r\n",
        "GET /api/v1/state HTTP/1.1\r\n" + host + "X-Api-Key: wrong\r\n" + key + "\r\n",
        empty_post + key + "Content-Length: 2\r\nContent-Length: 3\r\n\r\n{}",
        empty_post + key + "Content-Length: 2\r\nTransfer-Encoding: chunked\r\n\r\n{}",
        empty_post + key + "Content-Length: 2, 3\r\n\r\n{}",
        empty_post + key + "Content-Length: -2\r\n\r\n{}",
        empty_post + key + "Content-Length: 99999999999999999999\r\n\r\n{}",
        empty_post + key + "Transfer-Encoding: gzip, chunked\r\n\r\n0\r\n\r\n",
        empty_post + key + "Origin: http://127.0.0.1\r\nOrigin: http://evil\r\n\r\n"}) {
    EXPECT_THAT(raw(port(), head), HasSubstr(" 400 ")) << head;
  }
  EXPECT_THAT(raw(port(), empty_post + key + "Expect: cake\r\nContent-Length: 2\r\n\r\n{}"),
              HasSubstr(" 417 "));
  EXPECT_THAT(
      raw(port(), "GET / HTTP/1.1\r\n" + host + "X: " + std::string(8000, 'x') +
                      "\r\nY: " + std::string(8000, 'x') + "\r\nZ: " + std::string(8000, 'x') +
                      "\r\nW: " + std::string(8000, 'x') + "\r\nV: " + std::string(8000, 'x')),
      HasSubstr(" 431 "));
  for (const char* bearer : {"Bearer ", "bearer ", "BEARER  "}) {
    EXPECT_EQ(
        client()
            .Get("/api/v1/state", {{"Authorization", std::string(bearer) + "0123456789abcdef"}})
            ->status,
        200)
        << bearer;
  }
}

TEST_F(WebTest, takes_only_numbers_of_jobs_as_such) {
  client().Post("/api/v1/jobs", form("G28 X\n", "a.gcode", "false"));
  for (const char* number : {"1e300", "-1e300", "99999999999999999999", "18446744073709551615",
                             "9223372036854775808", "1.5", "-1", "0", "true", "\"1\""}) {
    const auto answer = client().Post(
        "/api/v1/jobs/1/move", "{\"before\": " + std::string(number) + "}", "application/json");
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->status, 400) << number;
    EXPECT_THAT(answer->body, HasSubstr("`before` must be the number of a job")) << number;
  }
  EXPECT_EQ(posted("/api/v1/jobs/1/move", {{"before", 9223372036854775807}}), 404);
}

TEST_F(WebTest, says_what_is_wrong_with_a_body) {
  client().Post("/api/v1/jobs", form("G28 X\n", "a.gcode", "false"));
  const auto why = [this](const std::string& path, const std::string& body) {
    const auto answer = client().Post(path, body, "application/json");
    return answer ? json::parse(answer->body).at("error").get<std::string>() : "no answer";
  };
  EXPECT_EQ(why("/api/v1/jobs/1/hold", "{"), "the body is no JSON");
  EXPECT_EQ(why("/api/v1/jobs/1/hold", "{}"), "the field `held` is missing");
  EXPECT_EQ(why("/api/v1/jobs/1/hold", R"({"held": 1})"), "the field `held` must be true or false");
  EXPECT_EQ(why("/api/v1/printers/left/send", R"({"line": 1})"), "the field `line` must be a text");
  EXPECT_EQ(why("/api/job", R"({"command": 1})"), "the field `command` must be a text");
  EXPECT_THAT(why("/api/printer/command", R"({"commands": [1]})"),
              AllOf(HasSubstr("wrong type"), Not(HasSubstr("json.exception"))));
}

TEST_F(WebTest, says_what_is_wrong_with_a_form) {
  const auto why = [this](const std::string& type, const std::string& body,
                          const std::string& encoding = {}) {
    const std::string length = encoding.empty() ? "Content-Length: " + std::to_string(body.size())
                                                : "Transfer-Encoding: " + encoding;
    return raw(port(), "POST /api/v1/jobs HTTP/1.1\r\n" + host +
                           "Content-Type: multipart/form-data" + type + "\r\n" + length +
                           "\r\n\r\n" + body);
  };
  const auto part = [](const std::string& name) {
    return "--x\r\nContent-Disposition: form-data; name=\"file\"; filename=\"" + name +
           "\"\r\n\r\nG28\r\n--x--\r\n";
  };
  EXPECT_THAT(why("", part("a.gcode")), AllOf(HasSubstr(" 400 "), HasSubstr("has no boundary")));
  EXPECT_THAT(why("; boundary=", part("a.gcode")), HasSubstr("has no boundary"));
  EXPECT_THAT(why("; boundary=y", part("a.gcode")), HasSubstr("another boundary"));
  EXPECT_THAT(why("; boundary=x", "zz\r\n", "chunked"),
              AllOf(HasSubstr(" 400 "), HasSubstr("broken chunk")));
  EXPECT_THAT(why("; boundary=x", part("a;b.exe")),
              AllOf(HasSubstr(" 415 "), HasSubstr("a;b.exe")));
  EXPECT_THAT(why("; boundary=x", part("a.gcode")), HasSubstr(" 201 "));
  EXPECT_THAT(why("; boundary=x", part("../a;b.gcode")), HasSubstr(" 201 "));
  EXPECT_EQ(spool().jobs().back().name, "a;b.gcode");
  EXPECT_THAT(
      why("; boundary=x\r\nForm-Content-Type: multipart/form-data; boundary=y", part("b.gcode")),
      HasSubstr(" 201 "));
}

TEST_F(WebTest, says_what_is_wrong_with_an_address_or_a_method) {
  const auto unknown = client().Get("/nowhere");
  EXPECT_EQ(unknown->status, 404);
  EXPECT_THAT(unknown->body, HasSubstr("there is nothing of this name"));
  EXPECT_THAT(raw(port(), "DANCE / HTTP/1.1\r\n" + host + "\r\n"),
              HasSubstr("its method is unknown"));
}

}  // namespace
