// SPDX-License-Identifier: Apache-2.0
// A client of OctoPrint that others have written (Debian's python3-pyoctoprintapi), with a printer.
#include <gmock/gmock.h>

#include "directories.hpp"
#include "tests/host/web_fixture.hpp"
#include "tools/process/process.hpp"

namespace {

class OctoPrintClient : public host_test::WebTest,
                        public testing::WithParamInterface<const char*> {};

TEST_P(OctoPrintClient, follows_and_commands_a_printer) {
  serve({.key = "0123456789abcdef", .names = {}});
  begin_print(100'000, 10);
  const auto client =
      process::capture({.arguments = {"python3", PROJECT_DIRECTORY "/tests/host/octoprint_client.py",
                                      std::to_string(port()), GetParam(), "0123456789abcdef"},
                        .has_input = false});
  EXPECT_EQ(client.exit_status, 0) << client.output;
  std::vector<std::string> heats;
  for (const std::string& line : left.executed()) {
    if (line.starts_with("M1")) heats.push_back(line);
  }
  ASSERT_GE(heats.size(), 4u);
  heats.erase(heats.begin(), heats.end() - 4);
  EXPECT_THAT(heats, testing::ElementsAre("M140 S60", "M104 S200", "M104 S0", "M140 S0"));
}

INSTANTIATE_TEST_SUITE_P(AtPath, OctoPrintClient, testing::Values("/", "/printers/left/"),
                         [](const auto& each) {
                           return std::string(each.param).size() == 1 ? "root" : "printer";
                         });

}  // namespace
