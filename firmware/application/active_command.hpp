// SPDX-License-Identifier: Apache-2.0
// The current command as its handler sees it, from the first call to the last.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "application/argument_limit.hpp"
#include "application/tick_clock.hpp"
#include "application/tools.hpp"
#include "gcode/command.hpp"
#include "host_link/host_link.hpp"
#include "host_link/text_line.hpp"
#include "motion/fault.hpp"
#include "units/axes.hpp"
#include "units/event_bound.hpp"

namespace application {

// What a handler returns: call me again in the next pass, or I am done.
enum class Progress : bool { again, done };

// Why a command ends everything.
struct Fatal {
  enum class Reason : std::uint8_t { asked_for, homing, probing };  // M112, G28 or G29 that failed
  Reason reason{};
  motion::Fault fault{};  // the last two of homing
  units::Axis axis{};
};

// The reply to a command.
class Reply {
 public:
  explicit Reply(host_link::HostLink& link) : link_(link) {}

  void begin() {
    lines_said = 0;
    behind_ok.clear();
  }
  // One line; `again` where the link has no room for it yet.
  Progress say(std::string_view line) { return link_.say(line) ? Progress::done : Progress::again; }
  Progress say(const host_link::TextLine& line) { return say(line.view()); }

  std::size_t lines_said{};  // of a reply of several lines, counted by its handler
  host_link::TextLine behind_ok;  // " T:20.00 ..." of M105

 private:
  host_link::HostLink& link_;
};

class ActiveCommand : public Reply {
 public:
  // The handler's progress.
  enum class Phase : std::uint8_t {
    begin,  // nothing is done yet: the line may still be held or cancelled
    working,
    appending,  // moves of one line, each as soon as the planner has room
    heating,  // waits for heat
    asking,  // waits for the user
  };

  using Reply::Reply;

  void begin(std::string_view line) {
    Reply::begin();
    phase = Phase::begin;
    text = line;
    wait_cancelled = false;
    refused = false;
  }

  // A number of the line as a whole number and as millionths, clamped to the range of its row.
  std::optional<std::int64_t> integer(char letter) const;
  std::optional<std::int64_t> value(char letter) const;
  // P in milliseconds or S in seconds, cut likewise; 0 without.
  units::Milliseconds asked_time() const;
  // S in whole seconds, clamped likewise.
  std::optional<units::Milliseconds> seconds() const;
  // The axes whose letters the line has.
  units::AxisSet named_axes() const;

  // T, or the tool in use without it; none where the machine does not have it. Of a machine with
  // one tool T is not looked at.
  std::optional<std::size_t> asked_tool(const Tools& tools) const;
  // In Marlin's words.
  [[gnu::noinline]] Progress refuse_tool();

  // Reports why the command is not executed, as its only reply.
  Progress refuse(const host_link::TextLine& line) {
    refused = true;
    const Progress said = say(line);
    units::happens<units::Event::refused>();
    units::happens<units::Event::settled>();
    return said;
  }
  // Not inlined, or their lines would lie on the stack below each handler.
  [[gnu::noinline]] Progress refuse(std::string_view reason);
  [[gnu::noinline]] Progress refuse(const ArgumentLimit& violated);
  // `line` is "echo:" and the reason; a second line for it would need as much stack again.
  [[gnu::noinline]] Progress refuse_for(host_link::TextLine& line);
  [[gnu::noinline]] Progress refuse_unknown();
  // "echo:M906 not fitted"; G-codes would have moved, so they are refused.
  [[gnu::noinline]] Progress report_not_fitted();
  Progress end_everything(const Fatal& reason) {
    fatal = reason;
    return Progress::done;
  }

  std::string_view text;  // of the line
  gcode::Command command;
  ArgumentLimits limits;  // of its row
  Now now;
  Phase phase{Phase::begin};
  bool wait_cancelled{};
  bool refused{};
  std::optional<Fatal> fatal;
};

}  // namespace application
