// SPDX-License-Identifier: Apache-2.0
// What people hear of real prints, and that no receiver holds one up.
#include "host/notify/notifier.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "host/notify/webhook.hpp"
#include "tests/host/spooler_fixture.hpp"
#include "tests/notify/receiver.hpp"

namespace {

using namespace std::chrono_literals;
using notify_test::Receiver;
using queue::JobState;
using testing::ElementsAre;

class Notified : public host_test::SpoolerTest {
 protected:
  ~Notified() override { notifier.reset(); }
  void begin() {
    std::vector<std::unique_ptr<notify::Sink>> sinks;
    sinks.push_back(std::make_unique<notify::Webhook>(notify::webhook_of(receiver.url()),
                                                      [](const std::string&) {}));
    notifier =
        std::make_unique<notify::Notifier>(spool(), std::move(sinks), notify::EventFinder(500ms));
  }
  void expect_heard(const std::string& event) {
    expect_soon([&] { return std::ranges::contains(receiver.values("event"), event); },
                "no event " + event);
  }
  Receiver receiver;
  std::unique_ptr<notify::Notifier> notifier;
};

TEST_F(Notified, a_print_is_reported_from_the_bed_to_its_end) {
  expect_soon([&] { return printer_state().at("link") == "ready"; }, "not ready");
  begin();
  const auto id = upload(std::string("G28 X\nM0\nG1 X5 F6000\n"), "part.gcode", false, "left");
  expect_heard("bed_to_be_cleared");
  spool().set_bed_clear("left", true);
  expect_heard("user_awaited");
  spool().ask("left", {{"do", "resume"}});
  expect_state(id, JobState::finished);
  expect_heard("job_finished");
  EXPECT_THAT(receiver.values("event"),
              ElementsAre("bed_to_be_cleared", "job_started", "user_awaited", "job_finished"));
  for (const auto& body : receiver.bodies()) {
    EXPECT_EQ(body.at("printer"), "left");
    EXPECT_EQ(body.at("job"), id);
    EXPECT_EQ(body.at("file"), "part.gcode");
  }
  std::set<std::string> ids;
  for (const auto& each : receiver.values("id")) ids.insert(each);
  EXPECT_EQ(ids.size(), 4u) << "each has an id of its own";
}

TEST_F(Notified, a_refused_file_and_a_lost_printer_are_reported) {
  expect_soon([&] { return printer_state().at("link") == "ready"; }, "not ready");
  begin();
  upload("M9999\n");
  expect_heard("job_refused");
  left.unplug();
  expect_heard("printer_lost");
  left.plug_in();
  expect_heard("printer_back");
}

TEST_F(Notified, a_receiver_that_does_not_answer_holds_up_neither_print_nor_people) {
  receiver.hold();
  begin();
  const auto id = begin_print(200, 20);
  ASSERT_TRUE(receiver.has_begun(1));
  spool().ask("left", {{"do", "pause"}});
  expect_state(id, JobState::paused);
  spool().ask("left", {{"do", "resume"}});
  expect_printed(id);
  EXPECT_THAT(receiver.values("event"), testing::IsEmpty());
  receiver.release();
  expect_heard("job_finished");
}

}  // namespace
