// SPDX-License-Identifier: Apache-2.0
// The page firmware/application/gcodes.md against what the firmware answers to every code.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <optional>
#include <regex>
#include <set>
#include <string>

#include "directories.hpp"
#include "tests/application/dialogue.hpp"

namespace application_test {
namespace {

constexpr int highest_code = 999;

// The codes in the first column of the table.
std::set<std::string> documented() {
  std::ifstream page(PROJECT_DIRECTORY "/firmware/application/gcodes.md");
  std::set<std::string> codes;
  const std::regex code("`([GM][0-9]+)`");
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("| `")) continue;
    const std::string column = line.substr(0, line.find('|', 1));
    for (std::sregex_iterator found(column.begin(), column.end(), code), end; found != end; ++found)
      codes.insert((*found)[1]);
  }
  return codes;
}

// Those that the firmware does not call unknown. One that has not answered soon is being executed;
// the next code goes to another printer that was just switched on.
std::set<std::string> executed() {
  std::set<std::string> codes;
  std::optional<Printer> printer;
  for (const char letter : {'G', 'M'}) {
    for (int number = 0; number <= highest_code; ++number) {
      if (!printer) {
        printer.emplace();
        printer->reply();  // the greeting
      }
      const std::string code = fmt::format("{}{}", letter, number);
      printer->send(code);
      const auto answer = printer->reply(0.1);
      if (answer && answer->find("Unknown command") != std::string::npos) {
        EXPECT_EQ(printer->reply(0.1), "ok") << code;
        continue;
      }
      codes.insert(code);
      printer.reset();
    }
  }
  return codes;
}

TEST(gcode_table, names_the_codes_that_the_firmware_executes_and_no_others) {
  const auto table = documented(), firmware = executed();
  for (const auto& code : table) EXPECT_TRUE(firmware.contains(code)) << code << " is unknown";
  for (const auto& code : firmware)
    EXPECT_TRUE(table.contains(code)) << code << " is not documented";
}

}  // namespace
}  // namespace application_test
