// SPDX-License-Identifier: Apache-2.0
// What slicers and clients of OctoPrint send, as their sources have it.
#include <gmock/gmock.h>

#include <algorithm>

#include "tests/host/web_fixture.hpp"

namespace {

using host_test::WebTest;
using nlohmann::json;
using queue::JobState;
using testing::HasSubstr;
using testing::StartsWith;

TEST_F(WebTest, prusaslicer_tests_the_version_and_uploads) {
  const auto version = client().Get("/api/version", {{"X-Api-Key", "any"}});
  ASSERT_TRUE(version);
  EXPECT_LT(version->status, 400);
  const json text = json::parse(version->body);
  EXPECT_TRUE(text.at("api").is_string());
  EXPECT_THAT(text.at("text").get<std::string>(), StartsWith("OctoPrint"));
  const auto answer = client().Post("/api/files/local", form("G28 X\n", "Würfel.gcode"));
  EXPECT_EQ(answer->status, 201);
  EXPECT_FALSE(spool().find(1)->held);
  EXPECT_EQ(spool().find(1)->name, "Würfel.gcode");
}

TEST_F(WebTest, cura_wants_a_location_below_api_and_sends_its_fields_after_the_file) {
  EXPECT_TRUE(got("/api/settings").is_object());
  EXPECT_TRUE(got("/api/version").at("server").is_string());
  EXPECT_EQ(posted("/api/login", {{"passive", true}}), 200);
  EXPECT_TRUE(got("/api/printerprofiles").at("profiles").contains("_default"));
  auto items = form("G28 X\n", "c d.gcode", "false");
  std::swap(items[0], items[2]);
  const auto answer = client().Post("/api/files/local", items);
  EXPECT_EQ(answer->status, 201);
  EXPECT_THAT(answer->get_header_value("Location"), HasSubstr("/api/files/local/c%20d.gcode"));
  const json body = json::parse(answer->body);
  EXPECT_TRUE(body.at("done"));
  EXPECT_FALSE(body.at("effectivePrint"));
  EXPECT_EQ(body.at("files").at("local").at("name"), "c d.gcode");
  EXPECT_TRUE(spool().find(1)->held);
  EXPECT_EQ(client().Get("/plugin/appkeys/probe")->status, 404);
}

TEST_F(WebTest, heaters_have_targets_within_reason) {
  expect_soon([&] { return printer_state().at("link") == "ready"; }, "not ready");
  EXPECT_EQ(posted("/api/printer/bed", {{"command", "target"}, {"target", 60.4}}), 204);
  EXPECT_EQ(posted("//api/printer/tool", {{"command", "target"}, {"targets", {{"tool0", 200}}}}),
            204);
  const auto has = [this](const std::string& line) {
    bool found = false;
    left.with(
        [&](host_test::LinkPrinter& each) { found = std::ranges::contains(each.typed, line); });
    return found;
  };
  expect_soon([&] { return has("M140 S60") && has("M104 S200"); }, "no targets");
  for (const json& target : {json(-1), json(501), json("60"), json(), json(1e300)}) {
    EXPECT_EQ(posted("/api/printer/bed", {{"command", "target"}, {"target", target}}), 400);
    EXPECT_EQ(
        posted("/api/printer/tool", {{"command", "target"}, {"targets", {{"tool0", target}}}}),
        400);
  }
  EXPECT_EQ(posted("/api/printer/bed", {{"command", "offset"}, {"offset", 1}}), 400);
  EXPECT_EQ(posted("/api/printer/bed", {{"command", "target"}, {"target", 60}, {"offset", 5}}),
            400);
  EXPECT_EQ(posted("/api/printer/tool", {{"command", "target"}, {"targets", {{"tool1", 200}}}}),
            400);
}

TEST_F(WebTest, a_client_follows_pauses_and_cancels_the_job) {
  expect_soon([&] { return printer_state().at("link") == "ready"; }, "not ready");
  EXPECT_EQ(got("/api/connection").at("current").at("state"), "Operational");
  EXPECT_EQ(got("/api/job").at("state"), "Operational");
  EXPECT_TRUE(got("/api/job").at("job").at("file").at("name").is_null());
  const auto id = upload_moves(3000);
  spool().set_bed_clear("left", true);
  expect_executed(100);
  expect_state(id, JobState::printing);
  const json job = got("/api/job");
  EXPECT_EQ(job.at("state"), "Printing");
  EXPECT_EQ(job.at("job").at("file").at("name"), "moves.gcode");
  EXPECT_GT(job.at("progress").at("completion"), 0.0);
  const json printer = got("/api/printer");
  EXPECT_EQ(printer.at("temperature").at("tool0").at("actual"), 21.5);
  EXPECT_TRUE(printer.at("state").at("flags").at("printing"));
  EXPECT_EQ(posted("/api/job", {{"command", "pause"}, {"action", "pause"}}), 204);
  expect_state(id, JobState::paused);
  EXPECT_EQ(got("/api/job").at("state"), "Paused");
  EXPECT_TRUE(got("/api/printer").at("state").at("flags").at("paused"));
  EXPECT_EQ(posted("/api/job", {{"command", "pause"}, {"action", "toggle"}}), 204);
  expect_state(id, JobState::printing);
  EXPECT_EQ(posted("/api/printer/command", {{"commands", {"M117 a", "M117 b"}}}), 204);
  EXPECT_EQ(posted("/api/job", {{"command", "start"}}), 409);
  EXPECT_EQ(posted("/api/job", {{"command", "cancel"}}), 204);
  expect_state(id, JobState::cancelled);
  EXPECT_EQ(posted("/api/job", {{"command", "cancel"}}), 409);
  EXPECT_EQ(posted("/api/job", {{"order", "cancel"}}), 400);
}

TEST_F(WebTest, a_printer_that_does_not_answer_is_not_operational) {
  left.unplug();
  expect_soon([&] { return printer_state().at("link") == "closed"; }, "still there");
  EXPECT_EQ(client().Get("/api/printer")->status, 409);
  EXPECT_EQ(got("/api/connection").at("current").at("state"), "Offline");
}

TEST_F(WebTest, each_printer_has_its_own_address_for_slicers) {
  const auto answer = client().Post("/printers/right/api/files/local", form("G28 X\n"));
  EXPECT_EQ(answer->status, 201);
  EXPECT_EQ(spool().find(1)->wanted_printer, "right");
  EXPECT_EQ(client().Get("/printers/right/api/version")->status, 200);
  EXPECT_EQ(client().Get("/printers/middle/api/job")->status, 404);
  EXPECT_EQ(client().Post("/printers/middle/api/files/local", form("G28 X\n"))->status, 404);
}

TEST_F(WebTest, lists_each_file_once) {
  for (int i = 0; i < 2; ++i) {
    client().Post("/api/files/local", form("G28 X\n", "a.gcode", "false"));
  }
  client().Post("/api/files/local", form("G28 X\n", "b.gcode", "false"));
  for (const char* path : {"/api/files", "/api/files/local"}) {
    const json files = got(path).at("files");
    ASSERT_EQ(files.size(), 2u);
    EXPECT_EQ(files.at(0).at("name"), "a.gcode");
    EXPECT_EQ(files.at(0).at("size"), 6);
  }
}

}  // namespace
