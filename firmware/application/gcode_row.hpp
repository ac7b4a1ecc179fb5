// SPDX-License-Identifier: Apache-2.0
// The contents of a row of the table of commands.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <string_view>

#include "application/argument_limit.hpp"
#include "application/command_groups.hpp"

namespace application {

// The condition for a command to begin, once the lines before it are done.
enum class Start : std::uint8_t {
  in_turn,
  with_room,  // in the planner
  at_rest,  // all motion has ended
  at_rest_but_with_s,  // the same, but not where S has a number
};

// Letters of a line that are alike: their unit ("" is a flag without a number), and what is checked
// of each.
struct Argument {
  std::string_view letters;  // none: the rest of the line is text
  std::string_view unit;
  ArgumentLimit limit;  // for each of the letters
};

inline constexpr std::string_view no_effect = "without effect";

consteval Argument text(std::string_view name) { return {"", name, {}}; }
consteval Argument flags(std::string_view letters) { return {letters, "", {}}; }
// The handler looks after what they are; `most` is for the page.
consteval Argument numbers(std::string_view letters, std::string_view unit, std::int32_t most = 0) {
  return {letters, unit, {.most = most}};
}
// A letter without a number is refused.
consteval Argument strict_numbers(std::string_view letters, std::string_view unit) {
  return {letters, unit, {.check = Check::number}};
}
// The nearest value in the range counts.
consteval Argument clamped(std::string_view letters, std::string_view unit, std::int8_t least,
                           std::int32_t most) {
  return {letters, unit, {.check = Check::clamped, .least = least, .most = most}};
}
// "S not within LEAST to MOST"
consteval Argument refused(std::string_view letters, std::string_view unit, std::int8_t least,
                           std::int32_t most) {
  return {letters, unit, {.check = Check::refused, .least = least, .most = most}};
}
// A tool that is not there is refused.
consteval Argument hotend_of_tool(std::string_view letters) {
  return {letters, "(tool)", {.check = Check::tool, .most = units::most_tools - 1}};
}
consteval Argument required(Argument argument) {
  argument.limit.required = true;
  return argument;
}

class Arguments {
 public:
  consteval Arguments() = default;
  consteval Arguments(std::initializer_list<Argument> list) : count_(list.size()) {
    std::ranges::copy(list, arguments_.begin());
  }

  constexpr const Argument* begin() const { return arguments_.data(); }
  constexpr const Argument* end() const { return arguments_.data() + count_; }
  constexpr bool empty() const { return count_ == 0; }

 private:
  static constexpr std::size_t most = 4;
  std::array<Argument, most> arguments_{};
  std::size_t count_{};
};

struct Conduct {
  Start start{};
  Handler report{};  // called in its place where none of the arguments is given
  bool
      refuses_others{};  // a letter that is not among the arguments: one of its axes would not move
  std::uint8_t most_subcode{};  // 6 of M862.6; a higher one is unknown
  bool on_reception{};  // acted on ahead of the lines that wait (host_link/emergency)
  bool answered_ahead{};  // a query that need not wait for them (HostLink::query)
  bool while_storing{};  // executed between M28 and M29
  bool while_dry_run{};  // decides what lines after it mean, also after a refused M37 or M111

  // Questions are answered wherever they are.
  constexpr bool executed_in_dry_run() const { return while_dry_run || while_storing; }
};

struct GcodeRow {
  char letter{};
  std::uint16_t code{};
  Handler handler{};  // none: the link acts on the line and answers it
  std::string_view help;  // for the page
  Arguments arguments;
  Conduct conduct;
};

// Rows as they are written in the table.
consteval GcodeRow g(std::uint16_t code, Handler handler, std::string_view help,
                     Arguments arguments = {}, Conduct conduct = {}) {
  return {'G', code, handler, help, arguments, conduct};
}
consteval GcodeRow m(std::uint16_t code, Handler handler, std::string_view help,
                     Arguments arguments = {}, Conduct conduct = {}) {
  return {'M', code, handler, help, arguments, conduct};
}
consteval GcodeRow t(std::uint16_t code, Handler handler, std::string_view help) {
  return {'T', code, handler, help, {}, {}};
}

}  // namespace application
