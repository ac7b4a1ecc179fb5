// SPDX-License-Identifier: Apache-2.0
// The entries, made from the table by the compiler, and the search among them.
#include "application/gcode_entry.hpp"

#include <bit>

#include "application/gcode_table.hpp"
#include "units/call_table.hpp"
#include "units/loop_bound.hpp"

namespace application {
namespace {

// For the search, and one row for each.
constexpr bool comes_before(const GcodeRow& first, const GcodeRow& second) {
  return first.letter < second.letter ||
         (first.letter == second.letter && first.code < second.code);
}
static_assert(std::ranges::adjacent_find(gcode_table,
                                         [](const auto& first, const auto& second) {
                                           return !comes_before(first, second);
                                         }) == gcode_table.end(),
              "the rows of the table of commands are in order of letter and code");

// Two bits for the letter, as many for the code as the table's codes need.
constexpr unsigned code_bits = 14;

constexpr std::uint32_t key_of(char letter, std::uint32_t code) {
  if (letter == 'T') return 2u << code_bits;
  if (code >> code_bits != 0) {
    return ~0u;  // of no entry
  }
  return letter == 'G' ? code : 1u << code_bits | code;
}

// A list in the image, in which what is put twice stands once.
template <class Value>
class List {
 public:
  constexpr const Value* begin() const { return values_.data(); }
  constexpr const Value* end() const { return values_.data() + count_; }
  constexpr std::size_t size() const { return count_; }

  constexpr std::uint8_t place_of(const Value& value) const {
    return static_cast<std::uint8_t>(std::ranges::find(*this, value) - begin());
  }
  constexpr void put(const Value& value) {
    if (place_of(value) == count_) append(value);
  }
  constexpr void append(const Value& value) { values_[count_++] = value; }

 private:
  std::array<Value, 255> values_{};
  std::size_t count_{};
};

template <auto make>
consteval auto fitted() {
  constexpr auto list = make();
  std::array<typename std::decay_t<decltype(*list.begin())>, list.size()> values{};
  std::ranges::copy(list, values.begin());
  return values;
}

using Limits = List<ArgumentLimit>;

// What is checked of a row's arguments.
constexpr Limits limits_of(const GcodeRow& row) {
  Limits limits;
  for (const Argument& argument : row.arguments) {
    if (argument.limit.check == Check::none && !argument.limit.required) continue;
    for (const char letter : argument.letters) {
      ArgumentLimit limit = argument.limit;
      limit.letter = letter;
      limits.append(limit);
    }
  }
  return limits;
}

constexpr Limits list_limits() {
  Limits all;
  for (const GcodeRow& row : gcode_table) {
    const Limits limits = limits_of(row);
    if (!std::ranges::search(all, limits).empty() || limits.size() == 0) continue;
    for (const ArgumentLimit& limit : limits) all.append(limit);
  }
  return all;
}

constexpr auto all_limits = fitted<list_limits>();

struct ArgumentSet {
  std::uint32_t letters{};
  std::uint8_t first_limit{};  // of all limits
  std::uint8_t limit_count{};

  bool operator==(const ArgumentSet&) const = default;
};

constexpr ArgumentSet arguments_of(const GcodeRow& row) {
  ArgumentSet set;
  // Where nothing looks at them they are not kept: many sets are then the same.
  const bool compared = row.conduct.refuses_others || row.conduct.report != nullptr;
  for (const Argument& argument : row.arguments) {
    if (!compared) break;
    for (const char letter : argument.letters) set.letters |= gcode::Command::bit(letter);
  }
  const Limits limits = limits_of(row);
  set.limit_count = static_cast<std::uint8_t>(limits.size());
  if (limits.size() != 0) {
    set.first_limit = static_cast<std::uint8_t>(std::ranges::search(all_limits, limits).begin() -
                                                all_limits.begin());
  }
  return set;
}

constexpr List<ArgumentSet> list_argument_sets() {
  List<ArgumentSet> all;
  for (const GcodeRow& row : gcode_table) all.put(arguments_of(row));
  return all;
}

constexpr List<Handler> list_handlers() {
  List<Handler> all;
  for (const GcodeRow& row : gcode_table) all.put(row.handler);
  return all;
}

constexpr List<Handler> list_reports() {
  List<Handler> all;
  for (const GcodeRow& row : gcode_table) all.put(row.conduct.report);
  return all;
}

constexpr auto argument_sets = fitted<list_argument_sets>();
static_assert(std::ranges::max(argument_sets, {}, &ArgumentSet::limit_count).limit_count <=
              most_limits);
constexpr auto handlers = fitted<list_handlers>();
constexpr auto reports = fitted<list_reports>();

constexpr auto entries = [] {
  std::array<GcodeEntry, gcode_table.size()> list{};
  const auto all_sets = list_argument_sets();
  const auto all_handlers = list_handlers();
  const auto all_reports = list_reports();
  for (std::size_t i = 0; i < list.size(); ++i) {
    const GcodeRow& row = gcode_table[i];
    list[i] = GcodeEntry{.key = static_cast<std::uint16_t>(key_of(row.letter, row.code)),
                         .start = row.conduct.start,
                         .refuses_others = row.conduct.refuses_others,
                         .while_storing = row.conduct.while_storing,
                         .while_dry_run = row.conduct.executed_in_dry_run(),
                         .most_subcode = static_cast<std::uint8_t>(row.conduct.most_subcode & 7),
                         .argument_set = all_sets.place_of(arguments_of(row)),
                         .handler_index = all_handlers.place_of(row.handler),
                         .report_index = all_reports.place_of(row.conduct.report)};
  }
  return list;
}();

}  // namespace

bool GcodeEntry::is_of(const gcode::Command& command) const {
  return key == key_of(command.letter, command.code);
}

std::uint32_t GcodeEntry::letters() const { return argument_sets[argument_set].letters; }

ArgumentLimits GcodeEntry::limits() const {
  const ArgumentSet& set = argument_sets[argument_set];
  return {all_limits.data() + set.first_limit, set.limit_count};
}

bool GcodeEntry::has_handler() const { return handlers[handler_index] != nullptr; }

Handler GcodeEntry::handler() const {
  units::declare_call_by<handlers>();
  return handlers[handler_index];
}

Handler GcodeEntry::report() const {
  units::declare_call_by<reports>();
  return reports[report_index];
}

const GcodeEntry* find_entry(const gcode::Command& command) {
  const std::uint32_t key = key_of(command.letter, command.code);
  // The first of so many from `first` on that is not below; each round leaves half of them.
  std::size_t first = 0;
  std::size_t count = entries.size();
  units::LoopBound<std::bit_width(entries.size())> halves;
  while (count != 0) {
    halves.next();
    const std::size_t half = count / 2;
    const bool is_below = entries[first + half].key < key;
    first = is_below ? first + half + 1 : first;
    count = is_below ? count - half - 1 : half;
  }
  return first != entries.size() && entries[first].key == key ? &entries[first] : nullptr;
}

}  // namespace application
