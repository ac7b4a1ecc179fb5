// SPDX-License-Identifier: Apache-2.0
// M220 and M221: part of the speed and of the filament that lines ask for.
#include <algorithm>

#include "application/command_executor.hpp"
#include "host_link/emergency.hpp"

namespace application {
namespace {

constexpr std::int32_t unchanged = 100;  // percent
constexpr std::int64_t largest_percentage = host_link::largest_speed_factor;
constexpr std::string_view factor_out_of_range = "Factor not within 1 to 999";

Stretch part_of(std::int32_t percent, std::int32_t whole) {
  if (percent >= whole) return Pace::one;
  const auto part = static_cast<std::uint32_t>(percent);
  const auto all = static_cast<std::uint32_t>(whole);
  return (part * Pace::one + all / 2) / all;
}

}  // namespace

// S within 1 to 999, or 0.
std::int32_t CommandExecutor::factor() const {
  const auto percent = command_.integer('S').value_or(0);
  return percent < 1 || percent > largest_percentage ? 0 : static_cast<std::int32_t>(percent);
}

CommandExecutor::Progress CommandExecutor::report_factor(const char* name, std::int32_t percent) {
  host_link::TextLine line;
  return say(line.text(name).integer(percent).character('%'));
}

// For the lines behind it, as in Marlin. They are planned with all of it, so a person's stretch
// ends with the first of them.
CommandExecutor::Progress CommandExecutor::set_speed_factor() {
  const std::int32_t before = coordinates_.speed();
  if (!has_any("SRB")) return report_factor("FR:", before);
  std::int32_t speed = command_.has('R') ? kept_speed_ : before;
  if (command_.has('S')) speed = factor();
  if (speed == 0) return refuse(factor_out_of_range);
  if (command_.has('B')) kept_speed_ = before;
  if (!has_any("SR")) return Progress::done;
  coordinates_.set_speed(speed, speed);
  motion_.set_stretch(motion_.stretch(), Pace::one);
  return Progress::done;
}

// What is planned already is stretched where it is too fast; it cannot be made faster within the
// limits of the axes. Lines to come are planned with what they were, or 100 % of what they ask for,
// and stretched as well, so that nothing changes where the first of them begins; or with all of it
// where that is more.
void CommandExecutor::set_speed_at_once(std::int32_t percent) {
  const std::int32_t before = coordinates_.planned_speed();
  const std::int32_t least = motion_.stretches_time() ? std::min(before, unchanged) : 0;
  const std::int32_t planned = std::max(percent, least);
  coordinates_.set_speed(percent, planned);
  motion_.set_stretch(part_of(percent, before), part_of(percent, planned));
}

CommandExecutor::Progress CommandExecutor::set_flow_factor() {
  if (!command_.has('S')) return report_factor("echo:E0 Flow: ", coordinates_.flow());
  const std::int32_t flow = factor();
  if (flow == 0) return refuse(factor_out_of_range);
  coordinates_.set_flow(flow);
  return Progress::done;
}

}  // namespace application
