// SPDX-License-Identifier: Apache-2.0
// The entries, made from the table by the compiler, and the search among them.
#include "application/gcode_entry.hpp"

#include "application/gcode_table.hpp"

namespace application {
namespace {

// What is checked of a row's arguments, or of all rows'.
class LimitList {
 public:
  constexpr LimitList() = default;
  explicit constexpr LimitList(const GcodeRow& row) {
    for (const Argument& argument : row.arguments) {
      if (argument.limit.check == Check::none && !argument.limit.required) continue;
      for (const char letter : argument.letters) {
        put(argument.limit);
        limits_[count_ - 1].letter = letter;
      }
    }
  }

  constexpr const ArgumentLimit* begin() const { return limits_.data(); }
  constexpr const ArgumentLimit* end() const { return limits_.data() + count_; }
  constexpr std::size_t size() const { return count_; }
  // Where those of `part` stand one after the other; size() where they do not.
  constexpr std::size_t place_of(const LimitList& part) const {
    return static_cast<std::size_t>(std::ranges::search(*this, part).begin() - begin());
  }
  constexpr void put(const ArgumentLimit& limit) { limits_[count_++] = limit; }

 private:
  std::array<ArgumentLimit, 255> limits_{};
  std::size_t count_{};
};

// Rows that check the same share it.
consteval LimitList list_limits() {
  LimitList all;
  for (const GcodeRow& row : gcode_table) {
    const LimitList limits(row);
    if (all.place_of(limits) != all.size()) continue;
    for (const ArgumentLimit& limit : limits) all.put(limit);
  }
  return all;
}

constexpr auto all_limits = [] {
  constexpr LimitList list = list_limits();
  std::array<ArgumentLimit, list.size()> limits{};
  std::ranges::copy(list, limits.begin());
  return limits;
}();

constexpr auto entries = [] {
  std::array<GcodeEntry, gcode_table.size()> list{};
  const LimitList all = list_limits();
  for (std::size_t i = 0; i < list.size(); ++i) {
    const GcodeRow& row = gcode_table[i];
    std::uint32_t letters = 0;
    for (const Argument& argument : row.arguments) {
      for (const char letter : argument.letters) letters |= gcode::Command::bit(letter);
    }
    const LimitList limits(row);
    list[i] = {.letter = row.letter,
               .start = row.conduct.start,
               .refuses_others = row.conduct.refuses_others,
               .while_storing = row.conduct.while_storing,
               .while_dry_run = row.conduct.executed_in_dry_run(),
               .code = row.code,
               .first_limit = static_cast<std::uint8_t>(all.place_of(limits)),
               .limit_count = static_cast<std::uint8_t>(limits.size()),
               .letters = letters,
               .handler = row.handler,
               .report = row.conduct.report};
  }
  return list;
}();

}  // namespace

ArgumentLimits GcodeEntry::limits() const { return {all_limits.data() + first_limit, limit_count}; }

const GcodeEntry* find_entry(const gcode::Command& command) {
  const std::uint16_t code = command.letter == 'T' ? std::uint16_t{0} : command.code;
  const GcodeEntry* first = entries.data();
  const GcodeEntry* last = first + entries.size();
  while (first != last) {
    const GcodeEntry* middle = first + (last - first) / 2;
    if (middle->is_of(command)) return middle;
    if (middle->letter < command.letter ||
        (middle->letter == command.letter && middle->code < code)) {
      first = middle + 1;
    } else {
      last = middle;
    }
  }
  return nullptr;
}

}  // namespace application
