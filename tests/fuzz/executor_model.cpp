// SPDX-License-Identifier: Apache-2.0
// Lines to the firmware, its replies, and what must hold after each.
#include "tests/fuzz/executor_model.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "application/task_table.hpp"
#include "machine/machine.hpp"
#include "tests/fuzz/executor_state.hpp"
#include "tests/fuzz/property.hpp"

namespace fuzz {
namespace {

constexpr const application::MachineDescription& description = machine::machine;
constexpr std::uint32_t clocks_of_ms = InstantChip::clock_hz / 1000;

constexpr std::array max_c{description.hotend.max, description.bed.max};

std::int64_t number_behind(std::string_view text, std::string_view name) {
  std::int64_t number = 0;
  const std::size_t at = text.find(name);
  require(at != std::string_view::npos, "no {} in \"{}\"", name, text);
  std::from_chars(text.data() + at + name.size(), text.data() + text.size(), number);
  return number;
}

std::int64_t travel_steps(const motion::AxisLimits& limits) {
  return limits.travel.count() / 1000 * limits.steps_per_meter.count() / 1'000'000;
}

constexpr std::int64_t tolerance_steps = 8;
// Short passes first: most lines need one. After them each is as long as the motion under way.
constexpr unsigned short_passes = 2;
constexpr std::uint32_t short_pass_clocks = clocks_of_ms, long_pass_clocks = 60 * clocks_of_ms;
constexpr std::uint32_t longest_pass_clocks = 2000 * clocks_of_ms;
// Heat is due in each long pass and ends it, and so may a report.
constexpr auto passes_of_a_round = static_cast<unsigned>(application::passes_of_a_round);
// Within so many passes there is another line, if there is one.
constexpr unsigned longest_rest = 20 * passes_of_a_round;
// Of motion that is not waited for.
constexpr std::uint32_t long_motion_clocks = 20'000 * clocks_of_ms;
// Homing behind the last chords of an arc needs some 100.
constexpr unsigned most_passes = 100 * passes_of_a_round,
                   most_passes_of_wait = 6 * passes_of_a_round,
                   most_passes_at_the_end = 12 * passes_of_a_round;

}  // namespace

ExecutorModel::ExecutorModel(std::uint8_t state)
    : travel_holds_(state % executor_states != static_cast<std::size_t>(ExecutorState::started)) {
  restore(static_cast<ExecutorState>(state % executor_states));
}

bool ExecutorModel::halted() const { return executor_application().halted(); }

bool ExecutorModel::moves_long() const {
  const InstantChip& chip = instant_chip();
  return chip.busy_until > chip.time + long_motion_clocks;
}

bool ExecutorModel::moves() const {
  return instant_chip().busy_until > instant_chip().time ||
         (pass_of_line_ != 0 && passes_ - pass_of_line_ < longest_rest);
}

void ExecutorModel::send(std::string_view text) {
  static std::string bytes;
  bytes.assign(text);
  bytes += '\n';
  serial_line().to_firmware = bytes;
  passes_ = pass_of_line_ = 0;
}

void ExecutorModel::pass() {
  InstantChip& chip = instant_chip();
  const std::uint32_t lines = chip.lines_made;
  const bool is_short = ++passes_ <= short_passes;
  pass_executor(is_short ? short_pass_clocks : long_pass_clocks);
  if (chip.lines_made != lines) pass_of_line_ = passes_;
  if (!is_short && chip.busy_until > chip.time) {
    chip.time += std::min<std::uint64_t>(chip.busy_until - chip.time, longest_pass_clocks);
  }
  take_replies();
}

void ExecutorModel::take_replies() {
  std::string& said = serial_line().from_firmware;
  if (said.empty()) return;
  std::size_t begin = 0;
  for (std::size_t end; (end = said.find('\n', begin)) != std::string::npos; begin = end + 1) {
    const std::string_view line = std::string_view(said).substr(begin, end - begin);
    if (line.starts_with("ok")) {
      ++oks_;
    } else if (line.starts_with("X:")) {
      place_ = line;
    } else if (line.starts_with("echo:")) {
      rejected_ = rejected_ || line.contains(", not executed: \"") ||
                  line.starts_with("echo:Unknown command: \"");
      switched_off_ = switched_off_ || line.contains("heaters off");
    }
    require(!line.starts_with("Resend"), "a line without number is asked for again");
  }
  said.erase(0, begin);
}

// A few passes more would show an answer too many, but the next line does so as well.
bool ExecutorModel::await(unsigned oks, unsigned most) {
  while (oks_ < oks && passes_ < most && !halted() && !moves_long()) pass();
  require(oks_ <= oks, "an answer too many");
  return oks_ == oks && !halted();
}

bool ExecutorModel::exchange(std::string_view text, bool waits) {
  static Observation before;
  before.look();
  oks_ = 0;
  rejected_ = switched_off_ = false;
  send(text);
  const bool answered = await(1, waits ? most_passes_of_wait : most_passes);
  check_targets();
  check_extremes();
  if (!answered) return false;
  // What a fault has to say is sent within the next round.
  if (instant_chip().stopped() || (rejected_ && before.targets_have_changed())) {
    for (unsigned i = 0; i < passes_of_a_round; ++i) pass();
    if (halted()) return false;
  }
  if (rejected_ && !switched_off_) before.require_unchanged(text);
  return true;
}

bool ExecutorModel::end_wait() {
  send("M108");
  return await(2, most_passes);
}

void ExecutorModel::check_targets() const {
  for (std::size_t i = 0; i < executor_heaters.size(); ++i) {
    const auto target = executor_application().heat().loop(executor_heaters[i]).target();
    require(target <= max_c[i], "heater {} has the target {}", i, target.count());
    require(!halted() || target == thermal::HeaterLoop::off, "a halted printer has a target");
  }
}

void ExecutorModel::check_extremes() const {
  if (!travel_holds_) return;
  const InstantChip& chip = instant_chip();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t travel = travel_steps(description.limits.axes[axis]);
    require(chip.lowest[axis] >= -tolerance_steps && chip.highest[axis] <= travel + tolerance_steps,
            "axis {} was at steps {} to {} of 0 to {}", axis, chip.lowest[axis], chip.highest[axis],
            travel);
  }
}

void ExecutorModel::check_place() {
  oks_ = 0;
  rejected_ = false;
  send("M400");
  passes_ = short_passes;
  // Between M28 and M29 it is refused.
  if (!await(1, most_passes_at_the_end) || rejected_) return;
  send("M114");
  if (!await(2, most_passes)) return;
  check_extremes();
  check_reported_place(place_);
}

// "X:60.00 Y:60.00 Z:5.00 E:0.00 Count X:4800 Y:4800 Z:12800"
void ExecutorModel::check_reported_place(std::string_view report) const {
  constexpr std::array<std::string_view, 3> names{"X:", "Y:", "Z:"};
  const std::size_t middle = report.find("Count");
  require(middle != std::string_view::npos, "M114 says \"{}\"", report);
  for (std::size_t axis = 0; axis < names.size(); ++axis) {
    const std::int64_t count = number_behind(report.substr(middle), names[axis]);
    require(count == instant_chip().position[axis], "M114 counts {} steps of {}", count,
            instant_chip().position[axis]);
    if (!travel_holds_ || !origin_holds_) continue;
    const std::int64_t mm = number_behind(report, names[axis]);
    const std::int64_t travel_mm = description.limits.axes[axis].travel.count() / 1'000'000;
    require(mm >= 0 && mm <= travel_mm, "M114 says \"{}\", the travel is {} mm", report, travel_mm);
  }
}

void ExecutorModel::check_halt() {
  if (!halted()) return;
  oks_ = 0;
  const std::uint32_t lines = instant_chip().lines_made;
  send("M104 S200\nM140 S60\nG28\nM105");
  for (int i = 0; i < 3; ++i) pass();
  require(oks_ == 0, "a halted printer answers ok");
  check_targets();
  require(instant_chip().lines_made == lines && instant_chip().motors == 0,
          "a halted printer moves");
  for (std::size_t i = 0; i < InstantChip::channels; ++i) {
    require(instant_chip().heater_duty(i) == 0 || !instant_chip().supply_closed,
            "a halted printer heats");
  }
}

}  // namespace fuzz
