// SPDX-License-Identifier: Apache-2.0
// Which changes of the spooler's state are events, and which are none.
#include "host/notify/event_finder.hpp"

#include <gmock/gmock.h>

namespace {

using namespace std::chrono_literals;
using notify::Event;
using notify::EventFinder;
using notify::Json;
using notify::Time;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Json job(int id, const char* state, const char* wanted = "") {
  return {{"id", id},      {"name", "part.gcode"},     {"state", state}, {"held", false},
          {"printer", ""}, {"wanted_printer", wanted}, {"reason", "why"}};
}

Json printer(const char* name, const char* link = "ready", bool bed_clear = false) {
  return {{"name", name},   {"link", link},           {"fault", ""},
          {"job", nullptr}, {"bed_clear", bed_clear}, {"waits_for_user", false}};
}

class Finding : public testing::Test {
 protected:
  // The events of the next look, a second later: name, printer and job.
  std::vector<std::string> look() {
    now_ += 1000ms;
    std::vector<std::string> names;
    events = finder_.look(state, now_);
    for (const Event& each : events) {
      names.push_back(std::string(name_of(each.kind)) + " " + each.printer + " " +
                      (each.job ? std::to_string(*each.job) : ""));
    }
    return names;
  }
  Json& left() { return state.at("printers").at(0); }
  Json& right() { return state.at("printers").at(1); }
  Json& first_job() { return state.at("jobs").at(0); }

  Json state{{"printers", {printer("left"), printer("right")}}, {"jobs", Json::array()}};
  std::vector<Event> events;

 private:
  EventFinder finder_{5000ms};
  Time now_{0};
};

TEST_F(Finding, what_was_there_before_is_no_news) {
  state["jobs"] = Json::array({job(1, "finished"), job(2, "queued")});
  left()["waits_for_user"] = true;
  EXPECT_THAT(look(), IsEmpty());
  EXPECT_THAT(look(), IsEmpty());
}

TEST_F(Finding, a_job_is_reported_from_its_start_to_its_end) {
  state["jobs"] = Json::array({job(7, "starting", "left")});
  first_job()["printer"] = "left";
  left()["job"] = 7;
  look();
  const std::vector<std::pair<const char*, std::vector<std::string>>> course{
      {"printing", {"job_started left 7"}},
      {"paused", {"job_paused left 7"}},
      {"printing", {}},
      {"interrupted", {"job_interrupted left 7"}},
      {"queued", {"bed_to_be_cleared left 7"}},
      {"starting", {}},
      {"printing", {"job_started left 7"}},
      {"finished", {"job_finished left 7"}}};
  for (const auto& [name, wanted] : course) {
    first_job()["state"] = name;
    left()["job"] = first_job()["state"] == "queued" ? Json() : Json(7);
    EXPECT_EQ(look(), wanted) << name;
    EXPECT_THAT(look(), IsEmpty()) << "twice: " << name;
  }
  EXPECT_EQ(notify::to_json({.kind = notify::Kind::job_failed, .time_ms = 1'500'000'000'007}),
            (Json{{"id", ""},
                  {"event", "job_failed"},
                  {"printer", nullptr},
                  {"job", nullptr},
                  {"file", ""},
                  {"reason", ""},
                  {"time", "2017-07-14T02:40:00.007Z"}}));
}

TEST_F(Finding, a_failed_and_a_refused_job_are_reported_with_the_reason) {
  state["jobs"] = Json::array({job(1, "printing")});
  look();
  first_job()["state"] = "failed";
  state["jobs"].push_back(job(2, "refused", "right"));  // between two looks
  EXPECT_THAT(look(), ElementsAre("job_failed  1", "job_refused right 2"));
  EXPECT_EQ(events.at(1).reason, "why");
  EXPECT_EQ(events.at(1).file, "part.gcode");
}

TEST_F(Finding, an_old_job_that_is_shown_again_is_no_news) {
  state["jobs"] = Json::array({job(1, "finished"), job(2, "finished")});
  look();
  state["jobs"] = Json::array({job(2, "finished")});
  look();
  state["jobs"] = Json::array({job(1, "finished"), job(2, "finished")});
  EXPECT_THAT(look(), IsEmpty());
  state["jobs"].push_back(job(3, "cancelled"));
  EXPECT_THAT(look(), ElementsAre("job_cancelled  3"));
}

TEST_F(Finding, a_bed_is_to_be_cleared_where_a_job_waits_for_nothing_else) {
  look();
  state["jobs"] = Json::array({job(1, "queued", "left")});
  first_job()["held"] = true;
  EXPECT_THAT(look(), IsEmpty()) << "held";
  first_job()["held"] = false;
  EXPECT_THAT(look(), ElementsAre("bed_to_be_cleared left 1"));
  EXPECT_THAT(look(), IsEmpty()) << "once";
  left()["bed_clear"] = true;
  EXPECT_THAT(look(), IsEmpty());
  left()["bed_clear"] = false;
  left()["job"] = 1;
  first_job()["state"] = "printing";
  state["jobs"].push_back(job(2, "queued", "left"));
  EXPECT_THAT(look(), ElementsAre("job_started left 1")) << "the bed has a print on it";
  left()["job"] = nullptr;
  first_job()["state"] = "finished";
  EXPECT_THAT(look(), ElementsAre("job_finished left 1", "bed_to_be_cleared left 2"));
}

TEST_F(Finding, no_bed_is_to_be_cleared_for_a_job_that_another_printer_takes) {
  right()["bed_clear"] = true;
  look();
  state["jobs"] = Json::array({job(1, "queued")});
  EXPECT_THAT(look(), IsEmpty());
  right()["link"] = "asking";
  EXPECT_THAT(look(), ElementsAre("bed_to_be_cleared left 1"));
}

TEST_F(Finding, a_printer_is_lost_after_some_seconds_and_comes_back) {
  look();
  left()["link"] = "asking";
  for (int i = 0; i < 4; ++i) EXPECT_THAT(look(), IsEmpty());
  left()["link"] = "ready";
  EXPECT_THAT(look(), IsEmpty()) << "it was only slow";
  left()["link"] = "closed";
  for (int i = 0; i < 5; ++i) EXPECT_THAT(look(), IsEmpty());
  EXPECT_THAT(look(), ElementsAre("printer_lost left "));
  EXPECT_THAT(events.at(0).reason, HasSubstr("cable or power"));
  EXPECT_THAT(look(), IsEmpty()) << "once";
  left()["link"] = "ready";
  EXPECT_THAT(look(), ElementsAre("printer_back left "));
}

TEST_F(Finding, a_printer_that_was_never_there_is_lost_only_with_its_job) {
  state["printers"] = Json::array({printer("left", "closed")});
  for (int i = 0; i < 20; ++i) EXPECT_THAT(look(), IsEmpty());
  state["jobs"] = Json::array({job(1, "printing")});
  left()["job"] = 1;
  std::vector<std::string> all;
  for (int i = 0; i < 10; ++i) {
    for (const auto& each : look()) all.push_back(each);
  }
  EXPECT_THAT(all, ElementsAre("job_started  1", "printer_lost left 1"));
}

TEST_F(Finding, a_printer_that_waits_for_a_person_is_reported_once) {
  look();
  left()["waits_for_user"] = true;
  left()["link"] = "unknown";
  EXPECT_THAT(look(), IsEmpty()) << "old news of a feeder that is not heard";
  left()["link"] = "ready";
  EXPECT_THAT(look(), ElementsAre("user_awaited left "));
  EXPECT_THAT(look(), IsEmpty());
  left()["waits_for_user"] = false;
  EXPECT_THAT(look(), IsEmpty());
  left()["waits_for_user"] = true;
  EXPECT_THAT(look(), ElementsAre("user_awaited left "));
}

}  // namespace
