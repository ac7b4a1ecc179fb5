// SPDX-License-Identifier: Apache-2.0
// The table of commands and its page against what the firmware does with every code.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <regex>
#include <set>
#include <string>

#include "application/gcode_entry.hpp"
#include "application/gcode_table.hpp"
#include "directories.hpp"
#include "gcode/parser.hpp"
#include "host_link/emergency.hpp"
#include "host_link/line_receiver.hpp"
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
    for (std::sregex_iterator found(column.begin(), column.end(), code), end; found != end;
         ++found) {
      codes.insert((*found)[1]);
    }
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
  for (const auto& code : firmware) {
    EXPECT_TRUE(table.contains(code)) << code << " is not documented";
  }
}

using application::GcodeRow;

std::string name_of(const GcodeRow& row) { return fmt::format("{}{}", row.letter, row.code); }

gcode::Command command_of(char letter, int code) {
  gcode::Command command;
  command.letter = letter;
  command.code = static_cast<std::uint16_t>(code);
  return command;
}

TEST(gcode_table, is_searched_to_the_right_entry_for_every_code) {
  for (const char letter : {'G', 'M'}) {
    for (int code = 0; code <= 65'535; ++code) {
      const auto row = std::ranges::find_if(application::gcode_table, [&](const GcodeRow& each) {
        return each.letter == letter && each.code == code;
      });
      const auto* entry = application::find_entry(command_of(letter, code));
      ASSERT_EQ(entry != nullptr, row != application::gcode_table.end()) << letter << code;
      if (entry == nullptr) continue;
      EXPECT_TRUE(entry->is_of(command_of(letter, code))) << letter << code;
      EXPECT_EQ(entry->handler(), row->handler) << letter << code;
      EXPECT_EQ(entry->report(), row->conduct.report) << letter << code;
    }
  }
  EXPECT_EQ(application::find_entry(command_of('T', 7)),
            application::find_entry(command_of('T', 0)));
}

bool acts_on_reception(const std::string& text) {
  host_link::LineReceiver receiver;
  receiver.put(text + host_link::line_feed);
  return host_link::emergency_in(receiver.take()).has_value();
}

TEST(gcode_table, says_of_a_row_what_the_link_does_on_reception) {
  for (const GcodeRow& row : application::gcode_table) {
    EXPECT_EQ(acts_on_reception(name_of(row)), row.conduct.on_reception) << name_of(row);
  }
}

// Where a row has text, the parser must not read it as parameters.
TEST(gcode_table, says_of_a_row_what_the_parser_reads_as_text) {
  for (const GcodeRow& row : application::gcode_table) {
    const bool has_text = std::ranges::any_of(
        row.arguments,
        [](const application::Argument& argument) { return argument.letters.empty(); });
    const std::string line = name_of(row) + " Words here";
    const auto command = gcode::parse(line);
    EXPECT_EQ(command && command->text == "Words here", has_text) << name_of(row);
  }
}

// Sent while the user is waited for: its answer does not wait.
TEST(gcode_table, says_of_a_row_whether_it_is_answered_ahead) {
  for (const GcodeRow& row : application::gcode_table) {
    const bool restarts_numbering = row.code == 110;  // answered, so that a new host gets online
    if (row.letter != 'M' || row.conduct.on_reception || restarts_numbering) continue;
    Printer printer;
    printer.run(1);
    printer.send("M0");
    printer.run(0.5);
    printer.chip.from_firmware.clear();
    printer.send(name_of(row));
    printer.run(0.5);
    EXPECT_EQ(printer.chip.from_firmware.contains("ok"), row.conduct.answered_ahead)
        << name_of(row) << ": " << printer.chip.from_firmware;
  }
}

TEST(gcode_table, says_of_a_row_whether_it_is_executed_between_m28_and_m29) {
  for (const GcodeRow& row : application::gcode_table) {
    if (row.conduct.on_reception) continue;
    Printer printer;
    printer.run(1);
    printer.talk("-> M28 a\n<* No SD card until M29\n<- ok");
    printer.send(name_of(row));
    const auto answer = printer.reply();
    ASSERT_TRUE(answer.has_value()) << name_of(row);
    EXPECT_NE(answer->contains("until M29"), row.conduct.while_storing)
        << name_of(row) << ": " << *answer;
  }
}

TEST(gcode_table, says_of_a_row_whether_it_is_executed_in_a_refused_dry_run) {
  for (const GcodeRow& row : application::gcode_table) {
    if (row.conduct.on_reception || row.code == 111) {
      continue;  // the one that is refused
    }
    Printer printer;
    printer.run(1);
    printer.talk("-> M111 S8\n<* No dry run\n<- ok");
    printer.send(name_of(row));
    const auto answer = printer.reply();
    ASSERT_TRUE(answer.has_value()) << name_of(row);
    EXPECT_NE(answer->contains("until M111 S0"), row.conduct.executed_in_dry_run())
        << name_of(row) << ": " << *answer;
  }
}

TEST(gcode_table, refuses_letters_that_a_row_does_not_have_where_it_says_so) {
  for (const GcodeRow& row : application::gcode_table) {
    if (row.conduct.on_reception) continue;
    Printer printer;
    printer.send(name_of(row) + " Q1");
    const auto answer = printer.reply(1);
    EXPECT_EQ(answer && answer->contains("Unknown parameter"), row.conduct.refuses_others)
        << name_of(row);
  }
}

// Hosts send what needs a capability only where it is reported.
TEST(gcode_table, reports_the_capabilities_of_the_commands_that_it_has) {
  Printer printer;
  printer.talk(R"(
    -> M115
    <* FIRMWARE_NAME:StepFabric
    <- Cap:EEPROM:0
    <- Cap:AUTOREPORT_TEMP:1
    <- Cap:AUTOREPORT_POS:1
    <- Cap:PROGRESS:0
    <- Cap:EMERGENCY_PARSER:1
    <- Cap:SDCARD:0
    <- Cap:ARCS:1
    <- Cap:HOST_ACTION_COMMANDS:1
    <- Cap:PROMPT_SUPPORT:1
    <- Cap:ADVANCED_OK:0
    <- ok
    -> M500
    <- echo:EEPROM disabled, not executed: "M500"
    <- ok
    -> M20
    <- echo:Unknown command: "M20"
    <- ok
  )");
}

}  // namespace
}  // namespace application_test
