// SPDX-License-Identifier: Apache-2.0
// What slicers of host type PrusaLink send, as their sources have it, and PrusaLink's own clients.
#include <gmock/gmock.h>

#include "tests/host/raw_client.hpp"
#include "tests/host/web_fixture.hpp"

namespace {

using host_test::raw;
using host_test::WebTest;
using nlohmann::json;
using queue::JobState;
using testing::HasSubstr;

const httplib::Headers printing{{"Print-After-Upload", "?1"}, {"Overwrite", "?1"}};
const httplib::Headers overwriting{{"Overwrite", "?1"}};

class PrusaLinkTest : public WebTest {
 protected:
  int put(const std::string& path, const httplib::Headers& headers = {},
          const std::string& body = "G28 X\n") {
    const auto answer = client().Put(path, headers, body, "text/x.gcode");
    said = answer ? answer->body : "";
    return answer ? answer->status : 0;
  }
  std::string said;
};

TEST_F(PrusaLinkTest, takes_the_upload_of_a_slicer) {
  EXPECT_TRUE(got("/api/version").at("capabilities").at("upload-by-put"));
  const json storage = got("/api/v1/storage").at("storage_list").at(0);
  EXPECT_TRUE(storage.at("available"));
  EXPECT_FALSE(storage.at("read_only"));
  EXPECT_GT(storage.at("free_space"), 0);
  // The path of the storage, a slash, the name in per cent signs.
  const std::string place = "/api/v1/files" + storage.at("path").get<std::string>();
  EXPECT_EQ(put(place + "/W%C3%BCrfel%20a.gcode", printing, "G28 X\nG1 X5\n"), 201) << said;
  EXPECT_EQ(json::parse(said).at("name"), "Würfel a.gcode");
  EXPECT_EQ(json::parse(said).at("size"), 12);
  EXPECT_EQ(spool().find(1)->name, "Würfel a.gcode");
  EXPECT_EQ(spool().find(1)->bytes, 12);
  EXPECT_FALSE(spool().find(1)->held);
}

TEST_F(PrusaLinkTest, holds_a_job_that_is_not_to_be_printed_and_keeps_it_to_the_printer) {
  EXPECT_EQ(put("/printers/right/api/v1/files/local/a.gcode", overwriting), 201) << said;
  EXPECT_TRUE(spool().find(1)->held);
  EXPECT_EQ(spool().find(1)->wanted_printer, "right");
  EXPECT_EQ(put("/api/v1/files/local/b.gcode", {{"Print-After-Upload", "?0"}}), 201) << said;
  EXPECT_TRUE(spool().find(2)->held);
  EXPECT_EQ(spool().find(2)->wanted_printer, "");
}

TEST_F(PrusaLinkTest, refuses_parts_of_files_and_headers_that_contradict_themselves) {
  EXPECT_EQ(put("/api/v1/files/local/a.gcode", {{"Content-Range", "bytes 0-5/900"}}), 400);
  EXPECT_THAT(said, HasSubstr("Content-Range"));
  EXPECT_EQ(put("/api/v1/files/local/a.gcode",
                {{"Print-After-Upload", "?0"}, {"Print-After-Upload", "?1"}}),
            400);
  EXPECT_TRUE(spool().jobs().empty());
}

TEST_F(PrusaLinkTest, refuses_a_name_that_is_there_unless_it_may_overwrite) {
  EXPECT_EQ(put("/api/v1/files/local/a.gcode"), 201);
  EXPECT_EQ(put("/api/v1/files/local/a.gcode"), 409);
  EXPECT_EQ(put("/api/v1/files/local/folder/a.gcode", {{"Overwrite", "?0"}}), 409);
  EXPECT_EQ(put("/api/v1/files/local/a.gcode", overwriting), 201);
  EXPECT_EQ(spool().jobs().size(), 2u);
}

TEST_F(PrusaLinkTest, refuses_what_is_no_upload_and_writes_nothing) {
  EXPECT_EQ(put("/api/v1/files/usb/a.gcode"), 404);
  EXPECT_EQ(put("/api/v1/files/local/a.exe"), 415);
  EXPECT_EQ(put("/api/v1/files/local/a.gcode", {}, ""), 400);
  EXPECT_EQ(put("/api/v1/files/local/a.gcode", {{"Overwrite", "yes"}}), 400);
  EXPECT_EQ(put("/printers/middle/api/v1/files/local/a.gcode"), 404);
  const std::string head = "PUT /api/v1/files/local/a.gcode HTTP/1.1\r\nHost: 127.0.0.1\r\n";
  EXPECT_THAT(raw(port(), head + "\r\n"), HasSubstr(" 411 "));
  EXPECT_THAT(raw(port(), head + "Content-Length: 9999999999\r\n\r\nG28"), HasSubstr(" 413 "));
  EXPECT_THAT(raw(port(), head + "Transfer-Encoding: chunked\r\n\r\nzz\r\n"), HasSubstr(" 400 "));
  EXPECT_THAT(
      raw(port(), head + "Content-Type: multipart/form-data; boundary=x\r\nContent-Length: 3"
                         "\r\n\r\nG28"),
      HasSubstr(" 415 "));
  EXPECT_TRUE(spool().jobs().empty());
  EXPECT_TRUE(spool().store().files().empty());
  // A path that leads elsewhere is a name like others.
  EXPECT_EQ(put("/api/v1/files/local/..%2F..%2Fetc%2Fx.gcode"), 201) << said;
  EXPECT_EQ(spool().find(1)->name, "x.gcode");
}

TEST_F(PrusaLinkTest, needs_the_key_for_all_its_routes) {
  serve({.key = "0123456789abcdef", .names = {}});
  for (const char* path : {"/api/version", "/api/v1/storage", "/api/v1/info", "/api/v1/status",
                           "/api/v1/job", "/api/openapi.json"}) {
    EXPECT_EQ(client().Get(path)->status, 403) << path;
    EXPECT_LT(client().Get(path, {{"X-Api-Key", "0123456789abcdef"}})->status, 300) << path;
  }
  EXPECT_EQ(put("/api/v1/files/local/a.gcode"), 403);
  EXPECT_EQ(put("/api/v1/files/local/a.gcode", {{"X-Api-Key", "0123456789abcdef"}}), 201);
}

TEST_F(PrusaLinkTest, a_client_follows_pauses_and_cancels_the_job) {
  expect_soon([&] { return printer_state().at("link") == "ready"; }, "not ready");
  EXPECT_EQ(got("/api/v1/info").at("name"), "left");
  EXPECT_EQ(got("/api/v1/status").at("printer").at("state"), "IDLE");
  EXPECT_FALSE(got("/api/v1/status").contains("job"));
  EXPECT_EQ(client().Get("/api/v1/job")->status, 204);
  const auto id = begin_print(3000, 100);
  const std::string job = "/api/v1/job/" + std::to_string(id);
  expect_soon([&] { return got("/api/v1/status").at("printer").at("state") == "PRINTING"; },
              "not printing");
  EXPECT_EQ(got("/api/v1/status").at("printer").at("temp_nozzle"), 21.5);
  const json now = got("/api/v1/job");
  EXPECT_EQ(now.at("id"), id);
  EXPECT_EQ(now.at("file").at("name"), "moves.gcode");
  EXPECT_GT(now.at("progress"), 0.0);
  EXPECT_LT(now.at("progress"), 100.0);

  const auto does = [&](const std::string& path) {
    const auto answer = client().Put(path, "", "text/plain");
    return answer ? answer->status : 0;
  };
  EXPECT_EQ(does("/api/v1/job/99/pause"), 404);
  EXPECT_EQ(does("/printers/right" + job + "/pause"), 404) << "it is on another printer";
  EXPECT_EQ(does(job + "/pause"), 204);
  expect_state(id, JobState::paused);
  EXPECT_EQ(got("/api/v1/job").at("state"), "PAUSED");
  EXPECT_EQ(does(job + "/resume"), 204);
  expect_state(id, JobState::printing);
  EXPECT_EQ(client().Delete("/api/v1/job/99")->status, 404);
  EXPECT_EQ(client().Delete(job)->status, 204);
  expect_state(id, JobState::cancelled);
}

}  // namespace
