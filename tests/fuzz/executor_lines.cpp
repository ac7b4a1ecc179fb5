// SPDX-License-Identifier: Apache-2.0
// Half of the mutations put a line in that is made from the table of commands: bytes alone seldom
// become one that is executed.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>

#include "application/gcode_table.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

using Random = std::minstd_rand;

std::size_t below(Random& random, std::size_t end) { return random() % end; }

// Borders of ranges, of the travel, of temperatures; small steps, and what is no number.
constexpr std::array<std::string_view, 32> numbers{
    "0",   "1",    "2",     "-1",   "0.5",      "10",          "-10",       "0.001",
    "60",  "100",  "110",   "120",  "140",      "199.9",       "200",       "200.001",
    "255", "275",  "300",   "-200", "999",      "1000",        "3000",      "12000",
    "60.", "-.01", "86400", "1e5",  "10000000", "99999999999", "4294967.3", ""};

std::string_view number(Random& random) { return numbers[below(random, numbers.size())]; }

// Moves often, since most commands are of no effect on a printer that does not move.
std::string line(Random& random) {
  const auto& table = application::gcode_table;
  const bool moves = below(random, 3) == 0;
  const application::GcodeRow& row = table[moves ? below(random, 4) : below(random, table.size())];
  std::string text(1, row.letter);
  text += std::to_string(row.code);
  const std::size_t share = 1 + below(random, 4);  // of its letters
  for (const application::Argument& argument : row.arguments) {
    for (const char letter : argument.letters) {
      if (below(random, 4) >= share) continue;
      if (below(random, 2) == 0) text += ' ';
      text += letter;
      text += number(random);
    }
  }
  return text + '\n';
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  Random random(seed);
  if (size == 0 || below(random, 2) == 0) return LLVMFuzzerMutate(data, size, most);
  std::string input(data, data + size);
  // Where a line begins.
  std::size_t place = input.find('\n', below(random, size));
  place = place == std::string::npos ? input.size() : place + 1;
  std::string added = line(random);
  if (place == input.size() && input.size() > 1 && input.back() != '\n') added.insert(0, 1, '\n');
  input.insert(place, added);
  size = std::min(input.size(), most);
  std::copy_n(input.begin(), size, data);
  return size;
}
