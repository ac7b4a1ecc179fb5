// SPDX-License-Identifier: Apache-2.0
// Files get other names; the metadata of one whose report is cut; what GET may not change.
#include <gmock/gmock.h>

#include "host/moonraker/files.hpp"
#include "tests/moonraker/fixture.hpp"

namespace {

using moonraker_test::Json;
using moonraker_test::SocketClient;

using FileTest = moonraker_test::MoonrakerTest;

std::vector<std::string> names_in(SocketClient& client) {
  std::vector<std::string> names;
  const Json answer = client.call("server.files.list");
  for (const Json& file : answer.at("result")) names.push_back(file.at("path"));
  return names;
}

TEST_F(FileTest, gets_another_name_with_all_of_its_jobs) {
  expect_ready();
  SocketClient client = front_end();
  const auto first = upload("G28 X\n", "a.gcode", true), second = upload("G28\n", "a.gcode", true);
  const auto others = upload("G28 X\n", "a.gcode", true, "right");
  const Json answer = client.call("server.files.move",
                                  {{"source", "gcodes/a.gcode"}, {"dest", "gcodes/b c.gcode"}});
  ASSERT_TRUE(answer.contains("result")) << answer;
  EXPECT_EQ(answer.at("result").at("action"), "move_file");
  EXPECT_EQ(answer.at("result").at("item").at("path"), "b c.gcode");
  EXPECT_EQ(answer.at("result").at("source_item").at("path"), "a.gcode");
  EXPECT_THAT(names_in(client), testing::ElementsAre("b c.gcode"));
  EXPECT_EQ(spool().find(first)->name, "b c.gcode");
  EXPECT_EQ(spool().find(second)->name, "b c.gcode");
  EXPECT_EQ(spool().find(others)->name, "a.gcode") << "the other printer's";
  EXPECT_TRUE(client.notified("notify_filelist_changed"));
}

TEST_F(FileTest, keeps_its_name_where_the_other_one_is_none_or_is_taken) {
  SocketClient client = front_end();
  upload("G28 X\n", "a.gcode", true);
  upload("G28 X\n", "b.gcode", true);
  const auto code = [&](const std::string& from, const std::string& to) {
    const Json answer = client.call("server.files.move", {{"source", from}, {"dest", to}});
    return answer.contains("error") ? answer.at("error").at("code").get<int>() : 0;
  };
  EXPECT_EQ(code("gcodes/a.gcode", "gcodes/b.gcode"), 403);
  EXPECT_EQ(code("gcodes/a.gcode", "gcodes/a.gcode"), 403);
  EXPECT_EQ(code("gcodes/none.gcode", "gcodes/c.gcode"), 404);
  for (const char* name : {"gcodes/d/c.gcode", "gcodes/../c.gcode", "gcodes/", "", "gcodes/c.txt",
                           "gcodes/c\n.gcode", "config/c.gcode"}) {
    EXPECT_EQ(code("gcodes/a.gcode", name), 400) << name;
  }
  EXPECT_THAT(names_in(client), testing::ElementsAre("a.gcode", "b.gcode"));
}

TEST_F(FileTest, has_as_many_layers_as_were_counted_though_not_all_are_listed) {
  moonraker::SettingsStore settings(folder_.path() / "other.db");
  moonraker::Core core{.spooler = spool(),
                       .settings = settings,
                       .printer = "left",
                       .access = moonraker::Access(""),
                       .guard = web::Guard({})};
  queue::Job job = spool().find(upload("G28 X\n", "a.gcode", true)).value();
  const auto metadata = [&](int count) {
    job.check =
        Json{{"layers", {{{"z_mm", 0.25}}, {{"z_mm", 0.5}}}}, {"layer_count", count}}.dump();
    return moonraker::metadata(core, job);
  };
  EXPECT_EQ(metadata(2).at("layer_count"), 2);
  EXPECT_EQ(metadata(2).at("object_height"), 0.5);
  EXPECT_EQ(metadata(7000).at("layer_count"), 7000);
  EXPECT_FALSE(metadata(7000).contains("object_height")) << "the last one is not known";
}

// A page of another site may send it.
TEST_F(FileTest, no_subscription_is_changed_by_get) {
  SocketClient client = front_end();
  const auto id = client.call("server.websocket.id").at("result").at("websocket_id").dump();
  const std::string path = "/printer/objects/subscribe?print_stats&connection_id=" + id;
  EXPECT_EQ(http().Get(path)->status, 404);
  EXPECT_EQ(http().Post(path, "{}", "application/json")->status, 200);
  EXPECT_EQ(http().Get("/printer/objects/query?print_stats")->status, 200);
}

}  // namespace
