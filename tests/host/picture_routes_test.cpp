// SPDX-License-Identifier: Apache-2.0
// What the page draws, over HTTP.
#include <gmock/gmock.h>

#include <chrono>

#include "tests/host/web_fixture.hpp"

namespace host_test {
namespace {

using queue::JobState;

TEST_F(WebTest, gives_the_path_of_a_job_by_layers_and_its_picture) {
  const std::string text = "M83\nM110 N5\nG1 Z0.2 F600\nG1 X10 E1\nG1 Z0.4\nG1 X0 E1\n";
  client().Post("/api/v1/jobs", form(text));
  expect_state(1, JobState::queued);
  const nlohmann::json head = got("/api/v1/jobs/1/path");
  EXPECT_EQ(head.at("layers"), nlohmann::json::parse("[[0.2, 2, 2], [0.4, 2, 5]]"))
      << "commands are counted as they are sent: without M110";
  const auto layer = client().Get("/api/v1/jobs/1/path/1");
  EXPECT_EQ(layer->status, 200);
  EXPECT_EQ(layer->body.size(), 16u);
  const auto picture = client().Get("/api/v1/jobs/1/picture");
  EXPECT_EQ(picture->get_header_value("Content-Type"), "image/png");
  EXPECT_TRUE(picture->body.starts_with("\x89PNG"));
  EXPECT_EQ(got("/api/v1/state").at("jobs")[0].at("has_picture"), true);
  for (const char* missing :
       {"/api/v1/jobs/1/path/2", "/api/v1/jobs/1/path/x", "/api/v1/jobs/2/path",
        "/api/v1/jobs/2/picture", "/api/v1/printers/middle/temperatures"}) {
    EXPECT_EQ(client().Get(missing)->status, 404) << missing;
  }
  // They go with the job.
  EXPECT_EQ(posted("/api/v1/jobs/1/cancel"), 200);
  EXPECT_EQ(client().Delete("/api/v1/jobs/1")->status, 200);
  EXPECT_TRUE(std::filesystem::is_empty(data() / "files"));
}

TEST_F(WebTest, has_neither_of_a_job_that_extrudes_nothing) {
  client().Post("/api/v1/jobs", form("G1 X10 F600\n"));
  expect_state(1, JobState::queued);
  EXPECT_EQ(client().Get("/api/v1/jobs/1/path")->status, 404);
  EXPECT_EQ(got("/api/v1/state").at("jobs")[0].at("has_path"), false);
  EXPECT_EQ(client().Get("/api/v1/jobs/1/picture")->status, 404);
  EXPECT_EQ(got("/api/v1/state").at("jobs")[0].at("has_picture"), false);
}

TEST_F(WebTest, gives_the_course_of_temperatures_with_a_gap_while_the_printer_is_away) {
  const auto samples = [&] { return got("/api/v1/printers/left/temperatures").at("samples"); };
  expect_soon([&] { return samples().size() >= 3; }, "no samples");
  EXPECT_EQ(samples()[0][1], 21.5);
  EXPECT_EQ(samples()[0][4], 20.25);
  left.unplug();
  expect_soon([&] { return printer_state().at("link") == "closed"; }, "still there");
  const std::int64_t last = samples().back()[0], heard = printer_state().at("answered_ms");
  EXPECT_LE(last, heard);
  const auto is_later = [&] {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    return now > std::chrono::milliseconds(heard + 5000);
  };
  expect_soon(is_later, "the clock stands");
  EXPECT_EQ(samples().back()[0], last);
  EXPECT_EQ(printer_state().at("answered_ms"), heard);
  left.plug_in();
  expect_soon([&] { return samples().back()[0] > last; }, "it does not go on");
  EXPECT_GE(samples().back()[0].get<std::int64_t>() - last, 5000);
}

}  // namespace
}  // namespace host_test
