// SPDX-License-Identifier: Apache-2.0
// Subscriptions, tokens, settings, times and scripts, without a server.
#include <gmock/gmock.h>

#include "host/moonraker/access.hpp"
#include "host/moonraker/printer_view.hpp"
#include "host/moonraker/rpc.hpp"
#include "host/moonraker/script.hpp"
#include "host/moonraker/settings_store.hpp"
#include "host/moonraker/subscription.hpp"
#include "tests/temporary_folder.hpp"

namespace {

using namespace moonraker;
using namespace std::chrono_literals;
using queue::JobState;

const Json objects{{"extruder", {{"temperature", 20.0}, {"target", 0.0}}},
                   {"webhooks", {{"state", "ready"}}}};

TEST(Subscription, has_the_fields_that_are_asked_and_nothing_of_what_is_not_there) {
  EXPECT_EQ(selected(objects, {{"extruder", nullptr}, {"laser", nullptr}}),
            (Json{{"extruder", {{"temperature", 20.0}, {"target", 0.0}}}}));
  EXPECT_EQ(selected(objects, {{"extruder", {"target", "colour"}}}),
            (Json{{"extruder", {{"target", 0.0}}}}));
  EXPECT_THROW(selected(objects, Json::array()), Error);
  EXPECT_THROW(selected(objects, {{"extruder", 5}}), Error);
}

TEST(Subscription, then_has_differences_only) {
  Subscription subscription{.wanted = {{"extruder", nullptr}}, .sent = {}};
  EXPECT_EQ(subscription.changes_to(objects).at("extruder").size(), 2u);
  EXPECT_TRUE(subscription.changes_to(objects).empty());
  Json later = objects;
  later["extruder"]["target"] = 200.0;
  later["webhooks"]["state"] = "startup";
  EXPECT_EQ(subscription.changes_to(later), (Json{{"extruder", {{"target", 200.0}}}}));
}

TEST(Access, a_oneshot_token_is_good_once_and_for_five_seconds) {
  auto now = Access::Clock::now();
  Access access("a key of 16 or more", [&now] { return now; });
  const std::string first = access.new_oneshot(), second = access.new_oneshot();
  EXPECT_NE(first, second);
  EXPECT_TRUE(access.take_oneshot(first));
  EXPECT_FALSE(access.take_oneshot(first));
  now += 6s;
  EXPECT_FALSE(access.take_oneshot(second));
  EXPECT_FALSE(access.is_good(second)) << "it is no login";
}

TEST(Access, a_login_needs_the_key_and_ends) {
  auto now = Access::Clock::now();
  Access access("a key of 16 or more", [&now] { return now; });
  EXPECT_THROW(access.log_in("another"), Error);
  EXPECT_FALSE(access.is_good(""));
  const std::string token = access.log_in("a key of 16 or more");
  const std::string other = access.log_in("a key of 16 or more");
  EXPECT_TRUE(access.is_good(token));
  access.log_out(token);
  EXPECT_FALSE(access.is_good(token));
  EXPECT_TRUE(access.is_good(other));
  now += 25h;
  EXPECT_FALSE(access.is_good(other));
}

TEST(Settings, are_kept_by_levels_of_names_and_outlive_the_process) {
  const TemporaryFolder folder;
  {
    SettingsStore store(folder.path() / "front_ends.db");
    store.set("mainsail", "gui.theme.mode", "dark");
    store.set("mainsail", "gui.theme.colour", "blue");
    store.set("fluidd", "", {{"a", 1}});
    EXPECT_EQ(store.remove("mainsail", "gui.theme.colour"), "blue");
  }
  SettingsStore store(folder.path() / "front_ends.db");
  EXPECT_THAT(store.namespaces(), testing::ElementsAre("fluidd", "mainsail"));
  EXPECT_EQ(store.item("mainsail", ""), (Json{{"gui", {{"theme", {{"mode", "dark"}}}}}}));
  EXPECT_EQ(store.item("mainsail", "gui.theme.mode"), "dark");
  EXPECT_THROW(store.item("mainsail", "gui.theme.colour"), Error);
  EXPECT_THROW(store.item("nothing", "x"), Error);
  EXPECT_THROW(store.set("mainsail", "gui.theme.mode.x", 1), Error) << "through a value";
  EXPECT_THROW(store.set("mainsail", "gui..x", 1), Error);
  EXPECT_THROW(store.set("mainsail", "big", std::string(2'000'000, 'x')), Error);
  EXPECT_EQ(store.item("mainsail", "").size(), 1u) << "nothing of what was refused";
}

TEST(Settings, are_not_without_end) {
  const TemporaryFolder folder;
  SettingsStore store(folder.path() / "front_ends.db");
  for (std::size_t i = 0; i < SettingsStore::most_namespaces; ++i) {
    store.set("n" + std::to_string(i), "a", 1);
  }
  EXPECT_THROW(store.set("one more", "a", 1), Error);
  store.set("n0", "a", 2);
}

TEST(Times, count_a_print_without_its_pauses) {
  const auto change = [](JobState from, JobState to, std::int64_t time_ms) {
    return queue::Change{.job = 1, .from = from, .to = to, .why = "", .time_ms = time_ms};
  };
  std::vector<queue::Change> history{change(JobState::queued, JobState::starting, 1000),
                                     change(JobState::starting, JobState::printing, 2000),
                                     change(JobState::printing, JobState::paused, 5000),
                                     change(JobState::paused, JobState::printing, 15'000)};
  EXPECT_EQ(times_of(history, 16'000).printing, 4);
  EXPECT_EQ(times_of(history, 16'000).total, 14);
  history.push_back(change(JobState::printing, JobState::finished, 20'000));
  const JobTimes times = times_of(history, 99'000);
  EXPECT_EQ(times.printing, 8);
  EXPECT_EQ(times.total, 18);
  EXPECT_EQ(times.started, 2);
  EXPECT_EQ(times.ended, 20);
  EXPECT_EQ(times_of({}, 5).started, 0);
}

std::vector<std::string> lines_of(std::string_view script, Work work = Work::none) {
  std::vector<std::string> lines;
  for (const Step& step : steps_of(script, work)) {
    const bool is_line = step.kind == Step::Kind::wish && step.wish.at("do") == "send";
    lines.push_back(is_line ? step.wish.at("line").get<std::string>() : "?");
  }
  return lines;
}

TEST(Script, has_gcode_and_the_commands_that_front_ends_send) {
  using testing::ElementsAre;
  EXPECT_THAT(lines_of("G28 X ; home\n\n m105\n"), ElementsAre("G28 X", "m105"));
  EXPECT_THAT(lines_of("SET_HEATER_TEMPERATURE HEATER=extruder TARGET=205"),
              ElementsAre("M104 S205"));
  EXPECT_THAT(lines_of("set_heater_temperature HEATER=heater_bed TARGET=0"),
              ElementsAre("M140 S0"));
  EXPECT_THAT(lines_of("TURN_OFF_HEATERS"), ElementsAre("M104 S0", "M140 S0"));
  EXPECT_THAT(lines_of("SAVE_GCODE_STATE NAME=_ui_movement\nG91\nG1 X10 F6000\n"
                       "RESTORE_GCODE_STATE NAME=_ui_movement"),
              ElementsAre("G91", "G1 X10 F6000", "G90", "M82"));
  EXPECT_EQ(steps_of("M112", Work::none).at(0).wish.at("do"), "stop");
  EXPECT_EQ(steps_of("PAUSE", Work::printing).at(0).wish.at("do"), "pause");
  EXPECT_EQ(steps_of("CANCEL_PRINT", Work::paused).at(0).wish.at("do"), "cancel");
  EXPECT_EQ(steps_of("SDCARD_PRINT_FILE FILENAME=\"a b.gcode\"", Work::none).at(0).file,
            "a b.gcode");
}

TEST(Script, is_refused_whole_where_a_line_is_wrong) {
  for (const char* script :
       {"G28\nBED_MESH_CALIBRATE", "SET_HEATER_TEMPERATURE HEATER=laser TARGET=5",
        "SET_HEATER_TEMPERATURE HEATER=extruder TARGET=hot", "SDCARD_RESET_FILE",
        "SET_HEATER_TEMPERATURE HEATER=extruder TARGET=nan",
        "SET_HEATER_TEMPERATURE HEATER=extruder TARGET=1e2",
        "SET_HEATER_TEMPERATURE HEATER=extruder TARGET=-1",
        "SET_HEATER_TEMPERATURE HEATER=extruder TARGET=200\rM112"}) {
    EXPECT_THROW(steps_of(script, Work::none), Error) << script;
  }
  std::string many;
  for (int i = 0; i < 51; ++i) many += "M105\n";
  EXPECT_THROW(steps_of(many, Work::none), Error);
}

TEST(Script, does_not_change_what_the_lines_of_a_job_mean) {
  for (const char* line : {"G91", "M83", "G92 X0", "G55", "M206 Z1", "SAVE_GCODE_STATE NAME=x"}) {
    EXPECT_THROW(steps_of(line, Work::printing), Error) << line;
    EXPECT_THROW(steps_of(line, Work::paused), Error) << line;
    steps_of(line, Work::none);
  }
  EXPECT_THROW(steps_of("G1 X5", Work::printing), Error);
  EXPECT_THROW(steps_of("G28", Work::printing), Error);
  steps_of("M104 S200\nM220 S90\nM117 G91", Work::printing);
}

}  // namespace
