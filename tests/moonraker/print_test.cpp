// SPDX-License-Identifier: Apache-2.0
// A whole print on the co-simulated chip through Moonraker's API, by a client that shares no code
// with the server: uploaded, started, paused, resumed, completed, to the step.
#include <gtest/gtest.h>

#include "tests/host/spooled_print.hpp"

namespace {

using namespace host_test;

class MoonrakerPrint : public SpooledPrint {
 protected:
  MoonrakerPrint() : SpooledPrint("moonraker_print") {}
};

TEST_F(MoonrakerPrint, makes_the_edges_of_print) {
  const std::string text = job(400);
  begin_chip();
  begin_spooler("chip=" + (folder / "port").string(), {"--moonraker", "127.0.0.1:0"});
  const std::string port = said_in_log("Moonraker of chip: http://127.0.0.1:([0-9]+)/");
  std::ofstream(folder / "part.gcode") << text;
  const auto client =
      process::capture({.arguments = {"python3", PROJECT_DIRECTORY "/tests/moonraker/front_end.py",
                                      port, folder / "part.gcode"},
                        .has_input = false});
  EXPECT_EQ(client.exit_status, 0) << client.output;
  EXPECT_EQ(job_state(), "finished");
  EXPECT_EQ(state().at("jobs").at(0).at("starts"), 1);
  expect_edges_of_print(text);
}

}  // namespace
