// SPDX-License-Identifier: Apache-2.0
// Shapers and K as lines, each line as a whole.
#include "application/shaping_commands.hpp"

#include <algorithm>
#include <optional>

#include "units/loop_bound.hpp"

namespace application {
namespace {

constexpr std::size_t shaped_axes = std::tuple_size_v<decltype(motion::ShapingSettings::shapers)>;

constexpr char small(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

constexpr std::size_t longest_name =
    std::ranges::max(motion::shaper_names, {}, &std::string_view::size).size();

bool is_name(std::string_view text, std::string_view name) {
  if (text.size() != name.size()) return false;
  units::LoopBound<longest_name, 1> characters;
  for (std::size_t i = 0; i < text.size(); ++i) {
    characters.next();
    if (small(text[i]) != name[i]) return false;
  }
  return true;
}

// Also RepRapFirmware's name of the two-hump EI.
std::optional<motion::ShaperType> type_named(std::string_view text) {
  units::LoopBound<motion::shaper_type_count> names;
  for (std::size_t i = 0; i < motion::shaper_type_count; ++i) {
    names.next();
    if (is_name(text, motion::shaper_names[i])) return static_cast<motion::ShaperType>(i);
  }
  if (is_name(text, "ei2")) return motion::ShaperType::two_hump_ei;
  return std::nullopt;
}

// In 1 / per_unit of the letter's unit; beyond its range one that is refused.
std::uint32_t fixed(std::int64_t millionths, std::uint32_t per_unit) {
  constexpr std::int64_t most = 1'000 * std::int64_t{gcode::millionths_per_unit};
  if (millionths < 0 || millionths > most) return 0x7FFF'FFFF;
  const std::uint32_t one = gcode::millionths_per_unit / per_unit;
  return (static_cast<std::uint32_t>(millionths) + one / 2) / one;
}

}  // namespace

host_link::TextLine shaping_report(std::size_t index, const motion::ShapingSettings& settings) {
  host_link::TextLine line;
  line.text("echo: M");
  if (index >= shaped_axes) {
    line.text("900 K").decimal(settings.advance_microseconds, 6, 4);
    return line;
  }
  const motion::Shaper& shaper = settings.shapers[index];
  line.text("593 ").character(units::axis_letters[index]).text(" P\"");
  line.text(motion::shaper_names[static_cast<std::size_t>(shaper.type)]).character('"');
  if (shaper.type == motion::ShaperType::none) return line;
  line.text(" F").decimal(shaper.millihertz, 3, 2).text(" D").decimal(shaper.damping, 4, 4);
  return line;
}

// Of the axes that are named, or of both. F0 switches off, and F alone a ZV shaper on, as in
// Marlin; P is the type and S the damping of RepRapFirmware.
Progress ShapingCommands::set_shapers(ActiveCommand& command) {
  if (!motion_.shapes()) return command.report_not_fitted();
  const gcode::Command& line = command.command;
  std::optional<motion::ShaperType> type;
  if (line.has('P')) {
    type = type_named(line.text);
    if (!type) return command.refuse("P is none of none, zv, zvd, mzv, ei, 2hump_ei");
  }
  const auto frequency = line.value('F');
  auto damping = line.value('D');
  if (!damping) damping = line.value('S');
  motion::ShapingSettings settings = motion_.shaping();
  const units::AxisSet named = command.named_axes();
  for (std::size_t i = 0; i < shaped_axes; ++i) {
    if (!named.empty() && !named.contains(static_cast<units::Axis>(i))) continue;
    motion::Shaper& shaper = settings.shapers[i];
    if (frequency) shaper.millihertz = fixed(*frequency, 1'000);
    if (damping) shaper.damping = fixed(*damping, motion::damping_one);
    if (type) {
      shaper.type = *type;
    } else if (frequency && shaper.type == motion::ShaperType::none) {
      shaper.type = motion::ShaperType::zv;
    }
    if (frequency && *frequency == 0) shaper.type = motion::ShaperType::none;
    if (shaper.damping > motion::most_damping) return command.refuse("D not within 0 to 0.9");
  }
  return set(command, settings, "F is too high or too low");
}

Progress ShapingCommands::set_advance(ActiveCommand& command) {
  if (!motion_.shapes()) return command.report_not_fitted();
  motion::ShapingSettings settings = motion_.shaping();
  const auto seconds = command.command.value(command.command.code == 572 ? 'S' : 'K');
  if (!seconds) return report(command);
  if (*seconds < 0 || *seconds > motion::most_advance_microseconds) {
    return command.refuse("K not within 0 to 10");
  }
  settings.advance_microseconds = static_cast<std::uint32_t>(*seconds);
  return set(command, settings, "Too long together with the shapers");
}

// What changes nothing does not stop the print: slicers repeat K for each feature.
Progress ShapingCommands::set(ActiveCommand& command, const motion::ShapingSettings& settings,
                              std::string_view reason) {
  if (settings == motion_.shaping()) return Progress::done;
  if (!motion_.at_rest()) {
    motion_.flush();
    return Progress::again;
  }
  return motion_.set_shaping(settings) ? Progress::done : command.refuse(reason);
}

Progress ShapingCommands::report(ActiveCommand& command) {
  if (!motion_.shapes()) return command.report_not_fitted();
  const bool shapers = command.command.code == 593;
  const std::size_t first = shapers ? 0 : shaped_axes;
  const std::size_t end = shapers ? shaped_axes : shaping_reports;
  std::size_t& said = command.lines_said;
  units::LoopBound<shaping_reports> lines;
  for (said = std::max(said, first); said < end; ++said) {
    lines.next();
    if (command.say(shaping_report(said, motion_.shaping())) == Progress::again) {
      return Progress::again;
    }
  }
  return Progress::done;
}

}  // namespace application
