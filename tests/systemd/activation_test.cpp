// SPDX-License-Identifier: Apache-2.0
// The spooler on a socket that systemd's own program opens and hands over.
#include <gmock/gmock.h>

#include "tests/host/spooled_print.hpp"
#include "tests/notify/strange_server.hpp"
#include "tools/files/file_text.hpp"

namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;
using testing::Not;

class ActivatedSpool : public host_test::SpooledPrint {
 protected:
  ActivatedSpool() : SpooledPrint("activated_spool") {}
};

TEST_F(ActivatedSpool, serves_on_the_socket_that_is_handed_over) {
  const std::string port = std::to_string(notify_test::StrangeServer("").port());
  spooler.emplace(process::Start{
      .arguments = {"systemd-socket-activate", "--listen=127.0.0.1:" + port,
                    "--setenv=STEPFABRIC_BUILD_DIR=" BUILD_DIRECTORY,
                    "--setenv=XDG_RUNTIME_DIR=" + (folder / "runtime").string(), "--setenv=PATH",
                    host_test::stepfabric, "spool", "--no-build", "--data", folder / "data",
                    "--printer", "left=" + (folder / "port").string(), "--listen", "127.0.0.1:1"},
      .output = folder / "spool.log",
      .has_input = false});
  address = "http://127.0.0.1:" + port;
  // The first request starts it, and is answered.
  expect_soon([&] { return !state().is_discarded(); }, "no answer");
  EXPECT_EQ(state().at("printers").at(0).at("name"), "left");
  EXPECT_EQ(said_in_log("(http://[0-9.:]+)/"), address);
  // Its feeder has neither the socket nor the variables.
  expect_soon([&] { return process::is_running(noted("left", "feeder.process")); }, "no feeder");
  const fs::path feeder = "/proc/" + std::to_string(noted("left", "feeder.process").id);
  expect_soon([&] { return fs::read_symlink(feeder / "exe").filename() == "stepfabric_feeder"; },
              "no feeder");
  EXPECT_THAT(files::text_of(feeder / "environ"), Not(HasSubstr("LISTEN_")));
  // What is left of the feeder listens nowhere: the port is free once the spooler has ended.
  spooler->signal(SIGTERM);
  EXPECT_EQ(spooler->wait().exit_status, 0) << files::text_of(folder / "spool.log");
  kill_feeder("left");
}

}  // namespace
