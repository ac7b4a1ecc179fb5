// SPDX-License-Identifier: Apache-2.0
// Properties of the parser: any bytes are handled, and a written command reads back as itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <random>
#include <string>

#include "gcode/parser.hpp"
#include "units/text.hpp"

namespace gcode {
namespace {

using Random = std::mt19937_64;

int between(Random& random, int low, int high) {
  return std::uniform_int_distribution<int>(low, high)(random);
}

// An error must point into the line (or just after it), a text must lie in it.
void check_result(const std::string& line) {
  const auto command = parse(line);
  if (!command) {
    ASSERT_LE(command.error().position, line.size()) << line;
    ASSERT_NE(describe(command.error()), "unknown fault");
    return;
  }
  ASSERT_TRUE(command->letter == 'G' || command->letter == 'M' || command->letter == 'T') << line;
  if (!command->text.empty()) {
    ASSERT_GE(command->text.data(), line.data());
    ASSERT_LE(command->text.data() + command->text.size(), line.data() + line.size());
  }
}

TEST(parser_properties, survives_random_bytes) {
  Random random(1);
  for (int round = 0; round < 200'000; ++round) {
    std::string line(static_cast<std::size_t>(between(random, 0, 40)), '\0');
    for (char& c : line) c = static_cast<char>(between(random, 0, 255));
    check_result(line);
  }
}

TEST(parser_properties, survives_random_gcode_characters) {
  Random random(2);
  const std::string alphabet = "GMTNXYZEFSgmx0123456789.+-  ;()*\"\t\xc3\x7f";
  for (int round = 0; round < 300'000; ++round) {
    std::string line = between(random, 0, 1) != 0 ? "G1 " : "";
    const int length = between(random, 0, 30);
    for (int i = 0; i < length; ++i) {
      line += alphabet[static_cast<std::size_t>(
          between(random, 0, static_cast<int>(alphabet.size()) - 1))];
    }
    check_result(line);
  }
}

struct Written {
  std::string line;
  char letter;
  int code;
  std::map<char, std::optional<std::int64_t>> parameters;
};

std::string blanks(Random& random) {
  constexpr std::string_view choices[]{"", "", " ", "  ", "\t"};
  return std::string(choices[between(random, 0, 4)]);
}

// Writes the value with a random but exact choice of sign, leading and trailing zeros.
std::string write_number(Random& random, std::int64_t value) {
  const std::uint64_t magnitude = static_cast<std::uint64_t>(value < 0 ? -value : value);
  std::string whole = std::to_string(magnitude / 1'000'000);
  std::string fraction = std::to_string(magnitude % 1'000'000);
  fraction.insert(0, 6 - fraction.size(), '0');
  while (!fraction.empty() && fraction.back() == '0' && between(random, 0, 3) != 0) {
    fraction.pop_back();
  }
  if (fraction.size() == 6 && between(random, 0, 3) == 0) fraction += "0499";
  if (whole == "0" && !fraction.empty() && between(random, 0, 1) != 0) whole.clear();
  if (between(random, 0, 5) == 0) whole.insert(0, "00");
  std::string text = value < 0 ? "-" : between(random, 0, 4) == 0 ? "+" : "";
  text += whole;
  if (!fraction.empty() || between(random, 0, 4) == 0) text += "." + fraction;
  return text == "." || text == "+." || text == "-." ? "0" : text;
}

Written write_command(Random& random) {
  Written written{"", "GMT" [between(random, 0, 2)], between(random, 2, 22), {}};
  written.line = blanks(random) + written.letter + blanks(random) + std::to_string(written.code);
  std::string letters = "ABCDEFHIJKLNOPQRSTUVWXYZ";
  std::shuffle(letters.begin(), letters.end(), random);
  letters.resize(static_cast<std::size_t>(between(random, 0, 12)));
  for (const char letter : letters) {
    std::optional<std::int64_t> value;
    if (between(random, 0, 9) != 0) {
      const std::int64_t limit = between(random, 0, 1) != 0 ? 300'000'000 : 4'294'967'295'999'999;
      value = std::uniform_int_distribution<std::int64_t>(-limit, limit)(random);
      if (between(random, 0, 3) == 0) *value = *value / 1'000'000 * 1'000'000;
    }
    written.parameters[letter] = value;
    written.line += blanks(random);
    written.line += between(random, 0, 3) == 0 ? static_cast<char>(letter - 'A' + 'a') : letter;
    written.line += blanks(random);
    if (value) written.line += write_number(random, *value);
  }
  if (between(random, 0, 5) == 0) written.line += "(note)";
  if (between(random, 0, 3) == 0) written.line += blanks(random) + ";X9 comment";
  return written;
}

TEST(parser_properties, reads_back_what_was_written) {
  Random random(3);
  for (int round = 0; round < 50'000; ++round) {
    const Written written = write_command(random);
    if (written.line.size() > units::longest_text) {
      continue;  // no longer line is parsed
    }
    const auto command = parse(written.line);
    ASSERT_TRUE(command.has_value()) << written.line << ": " << describe(command.error());
    ASSERT_TRUE(command->is(written.letter, static_cast<std::uint16_t>(written.code)))
        << written.line;
    for (char letter = 'A'; letter <= 'Z'; ++letter) {
      const auto expected = written.parameters.find(letter);
      ASSERT_EQ(command->has(letter), expected != written.parameters.end()) << written.line;
      if (expected != written.parameters.end()) {
        ASSERT_EQ(command->value(letter), expected->second) << written.line << " " << letter;
      }
    }
  }
}

}  // namespace
}  // namespace gcode
