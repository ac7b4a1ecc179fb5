// SPDX-License-Identifier: Apache-2.0
// Commands that act the moment they are received, ahead of all lines that wait.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace host_link {

struct EmergencyCommand {
  enum class Kind : std::uint8_t {
    kill,  // M112: everything off, until M999 or a reset
    cancel_wait,  // M108: end a wait for heat or for the user
    quick_stop,  // M410: stop all motion, forget the planned moves
    prompt_response,  // M876 S<n>: the user has pressed button n
    pause,  // //action:pause: no further line is begun
    resume,  // //action:resume: as before
    cancel,  // //action:cancel: as M410, and the lines that wait are not executed
    speed,  // M220 S<n> from a person, for the move under way too
  };
  static constexpr std::uint32_t kinds = 8;
  Kind kind;
  std::uint16_t value{};  // of M220 and M876: its S, otherwise 0
};

// The code of the M command at the start of `text`, which is then moved after it; 0 if
// there is none. `m 0112` is 112, as for the parser. Most lines have none: that takes no call.
std::uint32_t take_code_behind_m(std::string_view& text);
[[gnu::always_inline]] inline std::uint32_t take_m_code(std::string_view& text) {
  if (text.empty() || (text[0] != 'M' && text[0] != 'm')) return 0;
  return take_code_behind_m(text);
}

// To behind this letter, in either case; false where there is none.
bool skip_behind_letter(std::string_view& text, char capital);

struct ReceivedLine;

// The emergency command (M112, M108, M410, M602, M876 or //action:) that a line is, if it is one.
// M602 answers a prompt as M876 does.
std::optional<EmergencyCommand> emergency_in(const ReceivedLine& line);

// The factor of M220, in percent.
inline constexpr std::uint16_t largest_speed_factor = 999;

// M220 with an S of 1 .. largest_speed_factor and no more: it acts at once if a person sends it.
std::optional<EmergencyCommand> speed_in(const ReceivedLine& line);

// Those that wait to be acted on: one of each kind, the most urgent first.
class EmergencyQueue {
 public:
  void put(EmergencyCommand command);
  std::optional<EmergencyCommand> next();

 private:
  std::uint8_t pending_{};  // a bit for each kind
  std::uint16_t prompt_value_{};
  std::uint16_t speed_{};
};

}  // namespace host_link
