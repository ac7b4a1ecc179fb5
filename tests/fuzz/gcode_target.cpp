// SPDX-License-Identifier: Apache-2.0
// The firmware's parser: a command that is written out and parsed again is the same, and its
// numbers are those that the simulation's own reader finds in the line.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "gcode/parser.hpp"
#include "sim/report/gcode_words.hpp"
#include "tests/fuzz/property.hpp"

namespace {

using gcode::Command;
using gcode::Number;

bool lies_in(std::string_view part, std::string_view line) {
  return part.empty() ||
         (part.data() >= line.data() && part.data() + part.size() <= line.data() + line.size());
}

// The letter in front of a quoted text, or 0 where the text is not quoted.
char letter_of_quoted(const Command& command, std::string_view line) {
  if (command.text.data() == nullptr || command.text.data() == line.data()) return 0;
  const char* at = command.text.data() - 1;
  if (*at != '"' || command.is('M', 0) || command.is('M', 1) || command.text.data() < line.data()) {
    return 0;
  }
  while (--at >= line.data()) {
    if (*at == ' ' || *at == '\t') continue;
    const char letter = *at >= 'a' ? static_cast<char>(*at - 'a' + 'A') : *at;
    return command.has(letter) && !command.number(letter) ? letter : '\0';
  }
  return 0;
}

std::string written(const Command& command, std::string_view line) {
  std::string text = fmt::format("{}{}{}", command.in_machine_coordinates ? "G53 " : "",
                                 command.letter, command.code);
  if (command.subcode != 0) text += fmt::format(".{}", command.subcode);
  const char quoted = letter_of_quoted(command, line);
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    if (!command.has(letter)) continue;
    text += fmt::format(" {}", letter);
    if (const auto number = command.number(letter)) {
      text +=
          fmt::format("{}{}.{:09}", number->negative ? "-" : "", number->whole, number->billionths);
    }
    if (letter == quoted) text += fmt::format("\"{}\"", command.text);
  }
  if (quoted == 0 && !command.text.empty()) text += fmt::format(" {}", command.text);
  return text;
}

bool equal(const std::optional<Number>& one, const std::optional<Number>& other) {
  if (!one || !other) return one.has_value() == other.has_value();
  return one->whole == other->whole && one->billionths == other->billionths &&
         one->negative == other->negative;
}

void require_the_same_again(const Command& command, std::string_view line) {
  const std::string text = written(command, line);
  const auto again = gcode::parse(text);
  fuzz::require(again.has_value(), "\"{}\" was taken, but \"{}\" is not: {}", line, text,
                again ? "" : gcode::describe(again.error()));
  fuzz::require(again->letter == command.letter && again->code == command.code &&
                    again->subcode == command.subcode && again->text == command.text &&
                    again->in_machine_coordinates == command.in_machine_coordinates,
                "\"{}\" is read as \"{}\", which is read as another command", line, text);
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    fuzz::require(again->has(letter) == command.has(letter) &&
                      equal(again->number(letter), command.number(letter)),
                  "{} of \"{}\" is not that of \"{}\"", letter, line, text);
  }
}

// The judge of prints reads lines apart from the firmware.
void require_the_judges_numbers(const Command& command, std::string_view line) {
  if (!command.text.empty() || line.contains('"')) return;
  const report::GcodeWords all(line);
  const auto words = command.in_machine_coordinates ? all.without_first() : all;
  for (const report::GcodeWord& word : words.all()) {
    if (&word == words.all().data()) {
      fuzz::require(word.letter == command.letter, "the judge reads {} as \"{}\" begins",
                    word.letter, line);
      continue;
    }
    fuzz::require(command.has(word.letter), "only the judge finds {} in \"{}\"", word.letter, line);
    const auto number = command.number(word.letter);
    fuzz::require(number.has_value() == word.value.has_value(),
                  "only one finds a number behind {} in \"{}\"", word.letter, line);
    if (!number || number->whole >= 1'000'000'000) continue;
    const std::int64_t magnitude =
        std::int64_t{number->whole} * report::billionths + number->billionths;
    fuzz::require((number->negative ? -magnitude : magnitude) == *word.value,
                  "{} of \"{}\" is {} billionths for the judge", word.letter, line, *word.value);
  }
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    fuzz::require(command.has(letter) == words.has(letter), "the judge misses {} in \"{}\"", letter,
                  line);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t longest = 128;
  // Of exactly this size, so that a byte beyond it is seen.
  const std::string line(reinterpret_cast<const char*>(data), std::min(size, longest));
  const auto command = gcode::parse(line);
  if (!command) {
    fuzz::require(command.error().position <= line.size(), "an error lies behind \"{}\"", line);
    return 0;
  }
  fuzz::require(lies_in(command->text, line), "the text of \"{}\" is not of it", line);
  require_the_same_again(*command, line);
  require_the_judges_numbers(*command, line);
  return 0;
}
