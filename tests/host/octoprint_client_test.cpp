// SPDX-License-Identifier: Apache-2.0
// A client of OctoPrint that others have written (Debian's python3-pyoctoprintapi), with a printer.
#include <gmock/gmock.h>

#include "directories.hpp"
#include "tests/host/web_fixture.hpp"
#include "tools/process/process.hpp"

namespace {

class OctoPrintClient : public host_test::WebTest, public testing::WithParamInterface<const char*> {
 protected:
  // That did not come from a job.
  std::vector<std::string> heater_lines() {
    std::vector<std::string> lines;
    left.with([&](host_test::LinkPrinter& printer) {
      for (const std::string& line : printer.typed) {
        if (line.starts_with("M104") || line.starts_with("M140")) lines.push_back(line);
      }
    });
    return lines;
  }
};

TEST_P(OctoPrintClient, follows_and_commands_a_printer) {
  serve({.key = "0123456789abcdef", .names = {}});
  begin_print(100'000, 10);
  const auto client = process::capture(
      {.arguments = {"python3", PROJECT_DIRECTORY "/tests/host/octoprint_client.py",
                     std::to_string(port()), GetParam(), "0123456789abcdef"},
       .has_input = false});
  EXPECT_EQ(client.exit_status, 0) << client.output;
  const std::vector<std::string> wanted_lines{"M140 S60", "M140 S60", "M104 S200", "M104 S0",
                                              "M140 S0"};
  expect_soon([&] { return heater_lines() == wanted_lines; }, "other targets");
}

INSTANTIATE_TEST_SUITE_P(AtPath, OctoPrintClient, testing::Values("/", "/printers/left/"),
                         [](const auto& each) {
                           return std::string(each.param).size() == 1 ? "root" : "printer";
                         });

}  // namespace
