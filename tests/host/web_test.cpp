// SPDX-License-Identifier: Apache-2.0
// The server over real HTTP: REST, events, page, limits.
#include <gmock/gmock.h>

#include <chrono>

#include "host/web/page_files.hpp"
#include "tests/host/raw_client.hpp"
#include "tests/host/web_fixture.hpp"
#include "tools/files/file_text.hpp"

namespace {

using host_test::raw;
using host_test::WebTest;
using nlohmann::json;
using queue::JobState;
using testing::HasSubstr;

TEST_F(WebTest, an_upload_is_answered_when_its_job_and_its_file_are_there) {
  const auto answer = client().Post("/api/v1/jobs", form("G28 X\n", "../../a b.gcode", "false"));
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 201);
  const queue::JobId id = json::parse(answer->body).at("id");
  EXPECT_EQ(answer->get_header_value("Location"), "/api/v1/jobs/" + std::to_string(id));
  const auto job = spool().find(id).value();
  EXPECT_EQ(job.name, "a b.gcode");
  EXPECT_TRUE(job.held) << "print=false";
  EXPECT_EQ(files::text_of(spool().store().path_of(job.file)), "G28 X\n");
  expect_state(id, JobState::queued);
  EXPECT_EQ(got("/api/v1/jobs/1").at("check").at("refused").size(), 0u);
  EXPECT_EQ(got("/api/v1/jobs/1").at("history").at(0).at("to"), "checking");
}

TEST_F(WebTest, a_large_upload_arrives_whole) {
  std::string text;
  for (int i = 0; text.size() < 30'000'000; ++i) text += "; line " + std::to_string(i) + "\n";
  text += "G28 X\n";
  const auto answer = client().Post("/api/v1/jobs", form(text));
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 201);
  EXPECT_EQ(files::text_of(spool().store().path_of(spool().find(1)->file)), text);
}

TEST_F(WebTest, uploads_that_are_none_leave_nothing) {
  const auto status = [this](const httplib::MultipartFormDataItems& items) {
    const auto answer = client().Post("/api/v1/jobs", items);
    return answer ? answer->status : 0;
  };
  EXPECT_EQ(status(form("G28\n", "virus.exe")), 415);
  EXPECT_EQ(status(form("", "a.gcode")), 400);
  EXPECT_EQ(status({{.name = "print", .content = "true", .filename = "", .content_type = ""}}),
            400);
  auto two = form("G28\n");
  two.push_back(two.back());
  EXPECT_EQ(status(two), 400);
  auto many = form("G28\n");
  for (int i = 0; i < 30; ++i) many.insert(many.begin(), many.front());
  EXPECT_EQ(status(many), 400);
  EXPECT_EQ(posted("/api/v1/jobs", {{"file", "G28"}}), 400);
  const auto elsewhere = client().Post("/api/v1/jobs?printer=middle", form("G28\n"));
  EXPECT_EQ(elsewhere->status, 404);
  // Announced longer than a file may be, and ended early.
  const std::string head =
      "POST /api/v1/jobs HTTP/1.1\r\nHost: localhost\r\nContent-Type: multipart/form-data; "
      "boundary=x\r\nConnection: close\r\nContent-Length: ";
  EXPECT_THAT(raw(port(), head + "99999999999\r\n\r\n"), HasSubstr(" 413 "));
  EXPECT_EQ(spool().jobs().size(), 0u);
  EXPECT_TRUE(std::filesystem::is_empty(data() / "files"));
}

TEST_F(WebTest, changes_the_queue) {
  for (const char* name : {"a.gcode", "b.gcode", "c.gcode"}) {
    client().Post("/api/v1/jobs", form("G28 X\n", name, "false"));
  }
  EXPECT_EQ(posted("/api/v1/jobs/3/move", {{"before", 1}}), 200);
  EXPECT_EQ(spool().jobs().front().name, "c.gcode");
  EXPECT_EQ(posted("/api/v1/jobs/3/move", {{"before", nullptr}}), 200);
  EXPECT_EQ(spool().jobs().back().name, "c.gcode");
  EXPECT_EQ(posted("/api/v1/jobs/1/hold", {{"held", false}}), 200);
  EXPECT_FALSE(spool().find(1)->held);
  EXPECT_EQ(posted("/api/v1/jobs/2/cancel"), 200);
  EXPECT_EQ(posted("/api/v1/jobs/2/cancel"), 409);
  EXPECT_EQ(posted("/api/v1/jobs/2/again"), 200);
  EXPECT_EQ(spool().jobs().back().name, "b.gcode");
  EXPECT_EQ(client().Delete("/api/v1/jobs/2")->status, 200);
  EXPECT_EQ(client().Delete("/api/v1/jobs/2")->status, 404);
  EXPECT_EQ(posted("/api/v1/jobs/99/cancel"), 404);
  EXPECT_EQ(posted("/api/v1/jobs/1/move", {{"after", 1}}), 400);
  EXPECT_EQ(client().Post("/api/v1/jobs/1/move", "{", "application/json")->status, 400);
  EXPECT_EQ(posted("/api/v1/jobs/1/hold", {{"held", std::string(100'000, 'x')}}), 413);
  for (const auto& wrong :
       {nlohmann::json(-1), nlohmann::json("5"), nlohmann::json(1e9), nlohmann::json(true)}) {
    EXPECT_EQ(posted("/api/v1/printers/left/filament", {{"mm", wrong}}), 400);
  }
  EXPECT_EQ(posted("/api/v1/printers/left/filament", {{"mm", 1234.5}}), 200);
  EXPECT_EQ(posted("/api/v1/printers/left/filament"), 400);
  EXPECT_EQ(posted("/api/v1/printers/unknown/filament", {{"mm", 1}}), 404);
  EXPECT_EQ(spool().snapshot()->json.at("printers")[0].at("filament_mm"), 1234.5);
}

TEST_F(WebTest, prints_and_obeys_its_buttons) {
  client().Post("/api/v1/jobs", form("M117 a\n" + [] {
                  std::string moves;
                  for (int i = 0; i < 2000; ++i) moves += "M117 b\n";
                  return moves;
                }()));
  EXPECT_EQ(posted("/api/v1/printers/left/bed_clear", {{"clear", true}}), 200);
  expect_executed(20);
  EXPECT_EQ(posted("/api/v1/printers/left/pause"), 200);
  expect_state(1, JobState::paused);
  EXPECT_EQ(posted("/api/v1/printers/left/pause"), 409);
  EXPECT_EQ(posted("/api/v1/printers/left/send", {{"line", "M118 hello there"}}), 200);
  EXPECT_EQ(posted("/api/v1/printers/left/send", {{"line", "M110 N1"}}), 409);
  expect_soon([&] { return !left.executed().empty(); }, "");
  EXPECT_THAT(raw(port(), "POST /api/v1/printers/left/resume HTTP/1.1\r\nHost: localhost\r\n\r\n"),
              HasSubstr(" 200 "))
      << "without a body and its length";
  EXPECT_EQ(posted("/api/v1/printers/left/stop"), 200);
  expect_state(1, JobState::failed);
  EXPECT_EQ(posted("/api/v1/printers/middle/stop"), 404);
  EXPECT_EQ(posted("/api/v1/printers/left/dance"), 404);
  EXPECT_EQ(posted("/api/v1/printers/left/restart"), 409) << "no simulated one";
}

TEST_F(WebTest, sends_the_state_at_each_change_and_signs_of_life_in_between) {
  int states = 0, alive = 0;
  std::string text;
  auto listener = client();
  listener.set_read_timeout(30);
  listener.Get("/api/v1/events", [&](const char* data, std::size_t size) {
    text.append(data, size);
    for (std::size_t end = 0; (end = text.find("\n\n")) != std::string::npos;) {
      const std::string block = text.substr(0, end);
      text.erase(0, end + 2);
      if (block.starts_with("event: alive")) ++alive;
      if (block.find("event: state") != std::string::npos) {
        ++states;
        const json state = json::parse(block.substr(block.find("data: ") + 6));
        if (state.at("jobs").size() == 1) return false;
      }
    }
    if (alive == 1) spool().set_bed_clear("left", true);
    if (states >= 2) client().Post("/api/v1/jobs", form("G28 X\n", "a.gcode", "false"));
    return alive < 60;
  });
  EXPECT_GE(states, 2);
  EXPECT_LT(alive, 60);
}

TEST_F(WebTest, a_refused_request_is_not_the_envelope_of_another_one) {
  client().Post("/api/v1/jobs", form("G28 X\n", "a.gcode", "false"));
  const std::string inner =
      "POST /api/v1/jobs/1/cancel HTTP/1.1\r\nHost: localhost\r\nContent-Length: 0\r\n\r\n";
  const std::string outer =
      "POST /api/v1/jobs/1/hold HTTP/1.1\r\nHost: localhost\r\nOrigin: "
      "http://evil.example\r\nContent-Type: text/plain\r\nContent-Length: " +
      std::to_string(inner.size()) + "\r\n\r\n";
  EXPECT_THAT(raw(port(), outer, inner), HasSubstr(" 403 "));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_NE(spool().find(1)->state, JobState::cancelled);
}

TEST_F(WebTest, refuses_other_sites_other_names_and_missing_keys_over_http) {
  EXPECT_EQ(posted("/api/v1/printers/left/stop", {}, {{"Origin", "http://evil.example"}}), 403);
  EXPECT_EQ(client().Get("/api/v1/state", {{"Host", "evil.example"}})->status, 403);
  EXPECT_EQ(client().Get("/", {{"Host", "evil.example"}})->status, 403);
  serve({.key = "0123456789abcdef", .names = {}});
  EXPECT_EQ(client().Get("/")->status, 200);
  EXPECT_EQ(client().Get("/api/v1/state")->status, 403);
  EXPECT_EQ(client().Get("/api/v1/events")->status, 403);
  EXPECT_EQ(client().Post("/api/files/local", form("G28\n"))->status, 403);
  EXPECT_EQ(spool().jobs().size(), 0u);
  EXPECT_EQ(client().Get("/api/v1/state", {{"X-Api-Key", "0123456789abcdef"}})->status, 200);
  EXPECT_EQ(client().Get("/api/v1/state", {{"Authorization", "Bearer 0123456789abcdef"}})->status,
            200);
}

TEST_F(WebTest, listens_for_other_machines_only_with_a_key) {
  EXPECT_THROW(web::Server(spool(), {.host = "0.0.0.0", .port = 0}, {}), std::runtime_error);
  EXPECT_NO_THROW(web::Server(spool(), {.host = "0.0.0.0", .port = 0},
                              {.key = "0123456789abcdef", .names = {}}));
  EXPECT_THROW(
      web::Server(spool(), {.host = "127.0.0.1", .port = static_cast<std::uint16_t>(port())}, {}),
      std::runtime_error)
      << "in use";
}

TEST_F(WebTest, survives_requests_that_are_none) {
  for (const std::string& bytes :
       {std::string("\r\n\r\n"), std::string("GET\r\n\r\n"), std::string(200, '\0'),
        "GET / HTTP/1.1\r\nHost: localhost\r\nX: " + std::string(100'000, 'x') + "\r\n\r\n",
        "GET /" + std::string(20'000, 'a') + " HTTP/1.1\r\nHost: localhost\r\n\r\n",
        std::string("GET / HTTP/1.1\r\n\r\n"),
        std::string("POST /nowhere HTTP/1.1\r\nHost: "
                    "localhost\r\nContent-Length: "
                    "1000000000\r\n\r\nxx")}) {
    EXPECT_EQ(raw(port(), bytes).find(" 200 "), std::string::npos) << bytes.substr(0, 40);
  }
  EXPECT_EQ(client().Get("/api/v1/state")->status, 200);
}

TEST_F(WebTest, the_page_is_small_and_has_all_that_it_names) {
  std::size_t bytes = 0;
  for (const char* path : {"/", "/page.css", "/page.js"}) {
    const auto answer = client().Get(path);
    ASSERT_EQ(answer->status, 200) << path;
    bytes += answer->body.size();
    EXPECT_THAT(answer->get_header_value("Content-Security-Policy"),
                HasSubstr("default-src 'none'"));
  }
  EXPECT_LT(bytes, 200'000u);
  // Each element that the scripts look for is in the page.
  const std::string script(web::page_script), html(web::page_html);
  for (std::size_t at = 0; (at = script.find("byId('", at)) != std::string::npos; ++at) {
    const std::string id = script.substr(at + 6, script.find('\'', at + 6) - at - 6);
    EXPECT_THAT(html, HasSubstr("id=\"" + id + "\"")) << id;
  }
  for (const char* other : {"http://", "https://"}) {
    EXPECT_EQ(html.find(other), std::string::npos) << "it must work offline";
  }
}

}  // namespace
