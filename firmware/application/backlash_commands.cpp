// SPDX-License-Identifier: Apache-2.0
// M425, in Marlin's words.
#include <algorithm>

#include "application/setting_commands.hpp"
#include "application/setting_reports.hpp"
#include "units/loop_bound.hpp"

namespace application {

using motion::BacklashSettings;
using units::Nanometers;
using std::literals::operator""sv;

// What is taken up changes where the axes are, so they must be at rest.
Progress SettingCommands::set_fitted_backlash(ActiveCommand& command) {
  const gcode::Command& line = command.command;
  if (!line.has_any(gcode::Command::set_of("XYZF"))) {
    if (line.has('S')) return command.say("echo:M425 S without effect, there is no smoothing");
    return report_backlash(command);
  }
  BacklashSettings changed = motion_.backlash().settings();
  for (std::size_t i = 0; i < changed.lengths.size(); ++i) {
    const char letter = units::axis_letters[i];
    if (!line.has(letter)) continue;
    const auto asked = coordinates_.rounded_length(line, letter);
    if (!asked || *asked < Nanometers() || *asked > BacklashSettings::longest) {
      return command.refuse("X, Y or Z not within 0 to 5 mm");
    }
    changed.lengths[i] = *asked;
  }
  if (line.has('F')) {
    const auto asked = line.value('F');
    if (!asked) return command.refuse("F not within 0 to 1");
    constexpr std::int64_t whole = BacklashSettings::whole;
    changed.correction =
        static_cast<std::uint32_t>(*asked < 0 ? 0 : std::min<std::int64_t>(*asked, whole));
  }
  motion_.flush();
  if (!motion_.at_rest()) return Progress::again;
  motion_.set_backlash(changed);
  return Progress::done;
}

Progress SettingCommands::report_backlash(ActiveCommand& command) {
  constexpr std::size_t lines = 3;
  const BacklashSettings& settings = motion_.backlash().settings();
  units::LoopBound<lines> bound;
  for (; command.lines_said < lines; ++command.lines_said) {
    bound.next();
    host_link::TextLine line;
    switch (command.lines_said) {
      case 0:
        line.text("Backlash Correction ")
            .text(settings.correction == 0 ? "inactive:"sv : "active:"sv);
        break;
      case 1:
        line.text("  Correction Amount/Fade-out:     F").decimal(settings.correction, 6, 2);
        line.text(" (F1.0 = full, F0.0 = none)");
        break;
      default:
        line.text("  Backlash Distance (mm):        ");
        for (std::size_t i = 0; i < settings.lengths.size(); ++i) {
          line.character(' ').character(units::axis_letters[i]);
          line.decimal(settings.lengths[i].count(), 6, 3);
        }
    }
    if (command.say(line) == Progress::again) return Progress::again;
  }
  return Progress::done;
}

}  // namespace application
