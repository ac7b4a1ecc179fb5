// SPDX-License-Identifier: Apache-2.0
// `stepfabric spool` with a webhook and a broker, as a user starts it, killed with `kill -9`.
#include <gmock/gmock.h>

#include <algorithm>

#include "tests/host/spooled_print.hpp"
#include "tests/notify/broker.hpp"
#include "tests/notify/receiver.hpp"

namespace {

using notify_test::Broker;
using notify_test::Receiver;

class NotifiedSpool : public host_test::SpooledPrint {
 protected:
  NotifiedSpool() : SpooledPrint("notified_spool") {}
};

TEST_F(NotifiedSpool, reports_a_print_and_by_the_broker_its_own_death) {
  Receiver receiver;
  const Broker broker;
  const std::vector<std::string> options{"--webhook",      receiver.url(), "--mqtt",
                                         broker.address(), "--mqtt-topic", "shop/fabric"};
  begin_spooler("simulated", options);
  ASSERT_TRUE(broker.retains("shop/fabric/status", "online"));
  EXPECT_EQ(upload("G28 X\nG1 X20 F6000\nG1 X5\n"), "201");
  const auto heard = [&](const std::string& event) {
    return std::ranges::contains(receiver.values("event"), event);
  };
  expect_soon([&] { return heard("bed_to_be_cleared"); }, "no event of the bed");
  clear_bed("simulated");
  expect_soon([&] { return heard("job_finished"); }, "no event of the end");
  EXPECT_TRUE(broker.retains("shop/fabric/simulated/state", R"("state":"idle")"));
  kill_spooler();
  EXPECT_TRUE(broker.retains("shop/fabric/status", "offline")) << "the last will";
  begin_spooler("simulated", options);
  EXPECT_TRUE(broker.retains("shop/fabric/status", "online"));
  spooler->signal(SIGTERM);
  EXPECT_EQ(spooler->wait().exit_status, 0);
  EXPECT_EQ(broker.retained("shop/fabric/status"), "offline");
}

TEST_F(NotifiedSpool, refuses_receivers_that_are_none) {
  for (const std::vector<std::string>& wrong :
       {std::vector<std::string>{"--webhook", "ftp://host/"},
        {"--mqtt", "host:0"},
        {"--mqtt-login", "file"},
        {"--mqtt", "host", "--mqtt-login", "/missing"}}) {
    std::vector<std::string> call{host_test::stepfabric, "spool", "--data", folder / "data"};
    call.insert(call.end(), wrong.begin(), wrong.end());
    EXPECT_EQ(process::capture({.arguments = call, .has_input = false}).exit_status, 2) << wrong[1];
  }
}

}  // namespace
