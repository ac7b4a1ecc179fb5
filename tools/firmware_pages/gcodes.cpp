// SPDX-License-Identifier: Apache-2.0
// Writes the rows of the table of commands as Markdown.
#include "firmware_pages/pages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <span>
#include <vector>

#include "application/capabilities.hpp"
#include "application/gcode_table.hpp"

namespace firmware_pages {
namespace {

using application::Argument;
using application::Check;
using application::Start;

// What the page says of a row: the rest belongs to the chip alone.
struct Entry {
  char letter{};
  std::uint16_t code{};
  std::string_view help;
  application::Arguments arguments;
  Start start{};
  bool reports{};
  bool refuses_others{};
  bool on_reception{};
  bool answered_ahead{};
  bool while_storing{};
  bool in_dry_run{};
};

constexpr auto entries = [] {
  std::array<Entry, application::gcode_table.size()> list{};
  std::ranges::transform(application::gcode_table, list.begin(),
                         [](const application::GcodeRow& row) {
                           return Entry{.letter = row.letter,
                                        .code = row.code,
                                        .help = row.help,
                                        .arguments = row.arguments,
                                        .start = row.conduct.start,
                                        .reports = row.conduct.report != nullptr,
                                        .refuses_others = row.conduct.refuses_others,
                                        .on_reception = row.conduct.on_reception,
                                        .answered_ahead = row.conduct.answered_ahead,
                                        .while_storing = row.conduct.while_storing,
                                        .in_dry_run = row.conduct.while_dry_run};
                         });
  return list;
}();

std::string name_of(const Entry& entry) { return fmt::format("{}{}", entry.letter, entry.code); }

// "X Y Z E mm", or "S 1 to 999 %, refused beyond".
std::string text_of(const Argument& argument) {
  const auto& limit = argument.limit;
  std::string text = fmt::format("{}", fmt::join(argument.letters, " "));
  if (limit.check == Check::clamped || limit.check == Check::refused) {
    text += fmt::format(" {} to {}", limit.least, limit.most);
  } else if (limit.most != 0) {
    text += fmt::format(" up to {}", limit.most);
  }
  if (!text.empty() && !argument.unit.empty()) text += " ";
  text += argument.unit;
  if (limit.check == Check::refused) text += ", refused beyond";
  if (limit.required) text += ", required";
  return text;
}

std::string arguments_of(const Entry& entry) {
  std::vector<std::string> texts;
  for (const Argument& argument : entry.arguments) texts.push_back(text_of(argument));
  return fmt::format("{}", fmt::join(texts, "; "));
}

std::string begin_of(const Entry& entry) {
  if (entry.on_reception) return "on reception";
  if (entry.answered_ahead) return "ahead";
  switch (entry.start) {
    case Start::in_turn:
      return "";
    case Start::with_room:
      return "with room";
    case Start::at_rest:
      return "at rest";
    case Start::at_rest_but_with_s:
      return "at rest, but with S in turn";
  }
  return "";
}

// "G0, G1, G28 and G92"
template <class Predicate>
std::string names_where(Predicate predicate) {
  std::vector<std::string> names;
  for (const Entry& entry : entries) {
    if (predicate(entry)) names.push_back(name_of(entry));
  }
  if (names.size() < 2) return names.empty() ? "none" : names.front();
  const std::string last = names.back();
  names.pop_back();
  return fmt::format("{} and {}", fmt::join(names, ", "), last);
}

std::string capabilities() {
  std::vector<std::string> present, absent;
  // The last one is the machine's.
  const auto& all = application::capabilities();
  for (const auto& capability : std::span(all).first(all.size() - 1)) {
    (capability.present ? present : absent).push_back(fmt::format("`{}`", capability.name));
  }
  return fmt::format("{};\n  not: {}", fmt::join(present, ", "), fmt::join(absent, ", "));
}

}  // namespace

std::string gcodes() {
  std::string text =
      "# G-code table\n\n"
      "Generated from `gcode_table.hpp`: do not edit. What the firmware executes; everything else "
      "is answered with\n`echo:Unknown command` and an `ok`. Exceptions and decisions: "
      "[`README.md`](README.md), syntax: [`../gcode`](../gcode).\n\n"
      "| code | letters | does | begins |\n|---|---|---|---|\n";
  for (const Entry& entry : entries) {
    text += fmt::format("| `{}` | {}{} | {} | {} |\n", name_of(entry), arguments_of(entry),
                        entry.reports ? "; reports without any" : "", entry.help, begin_of(entry));
  }
  text += fmt::format(
      "\n- Lengths, also those in mm/s and mm/s², are in inches after G20. Of a number out of a "
      "range \"0 to 60\" the\n  nearest within counts; beyond \"up to\" the line is refused.\n"
      "- A letter without a unit is a flag. {} refuse a line with a letter that they do not have: "
      "one of its\n  axes would stay where it is. Others ignore it.\n"
      "- *At rest*: as soon as all motion before it has ended. *With room*: in the planner. "
      "*On reception*: at once, ahead of the\n  lines that wait. *Ahead*: the same while the user "
      "is waited for, M105 of a person also in the middle of a job.\n"
      "- From M28 to M29 nothing is executed but {}, and what acts on reception.\n"
      "- After a refused M37 or M111 the same are executed, and {}.\n"
      "- M115 reports {}\n  (`ADVANCED_OK` as the machine description says).\n",
      names_where([](const Entry& entry) { return entry.refuses_others; }),
      names_where([](const Entry& entry) { return entry.while_storing; }),
      names_where([](const Entry& entry) { return entry.in_dry_run; }), capabilities());
  return text;
}

}  // namespace firmware_pages
