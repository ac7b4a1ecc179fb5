// SPDX-License-Identifier: Apache-2.0
// Segments to the hardware, stops back from it.
#include "application/motion_task.hpp"

#include <algorithm>

#include "motion/s_curve.hpp"
#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"

namespace application {
namespace {

using units::index_of;

// The rate floor keeps a ramp that ends a little too low from standing still; no line is planned
// slower (motion::longest_tick).
constexpr std::uint32_t rate_floor_millihertz = 100;
static_assert(rate_floor_millihertz * motion::longest_tick.count() <= 1'000'000'000);
// Shorter pulses on an end stop's line are noise.
constexpr std::uint32_t end_stop_filter_ns = 2000;

// The queue lasts as long (task_timing::lines_of_a_pass) with ramps of two segments: a line with
// one has four, a line with two has five.
static_assert(motion::SCurve::least_clocks * 3 >= 4 * task_timing::least_line(false, true));
static_assert(motion::SCurve::least_clocks * 2 * 3 >= 5 * task_timing::least_line(false, true));

// A motor that stops dead swings about its place: if it reversed at once, it might lose steps.
constexpr units::Milliseconds ringing_time{50};

// The planner's, the one being handed over, those of as many segments, the one being executed.
constexpr std::uint32_t deepest_queue = 255;
// With shaping lines of as many slots are still under way.
constexpr std::uint32_t shaped_lines = motion::ShapingFilter::capacity * 4;
constexpr std::uint32_t lines_under_way = motion::Planner::capacity + deepest_queue + 2;

constexpr std::uint64_t nanoseconds_per_second = 1'000'000'000;

constexpr std::array all_axes{units::Axis::x, units::Axis::y, units::Axis::z, units::Axis::e};

units::PerAxis<drivers::GuardTimings> guards_of(const MachineDescription& machine,
                                                units::Hertz clock) {
  units::PerAxis<drivers::GuardTimings> guards;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    guards[i] = drivers::GuardTimings::of(machine.drivers[i], clock);
  }
  return guards;
}

std::optional<drivers::GuardTimings> second_guard_of(const MachineDescription& machine,
                                                     units::Hertz clock) {
  if constexpr (units::most_tools > 1) {
    if (machine.second_tool.has_value()) {
      return drivers::GuardTimings::of(machine.second_tool->driver, clock);
    }
  }
  return std::nullopt;
}

motion::StepTiming timing_of(const MachineDescription& machine, units::Hertz clock) {
  const auto time_of = [clock](std::int64_t clocks) {
    return units::Microseconds(clocks * 1'000'000 / clock.count() + 1);
  };
  const std::int64_t least_line = task_timing::least_line(machine.fast, machine.is_heavy());
  motion::StepTiming timing{.clock = clock,
                            .least_line_time = time_of(least_line),
                            .longest_pass = time_of(task_timing::lines_of_a_pass * least_line)};
  const auto guards = guards_of(machine, clock);
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    timing.max_step_rate[i] = units::Hertz(clock.count() / (guards[i].high + guards[i].low));
  }
  if (const auto second = second_guard_of(machine, clock)) {
    units::Hertz& rate = timing.max_step_rate[index_of(units::Axis::e)];
    rate = std::min(rate, units::Hertz(clock.count() / (second->high + second->low)));
  }
  return timing;
}

std::uint8_t end_stops_of(const motion::Limits& limits) {
  std::uint32_t inputs = 0;
  for (const motion::AxisLimits& axis : limits.axes) {
    if (axis.homing) inputs |= 1u << axis.homing->end_stop;
  }
  return static_cast<std::uint8_t>(inputs);
}

// The true 64-bit count nearest to `planned` whose low word is `counter`.
std::int64_t unwrapped(std::int32_t counter, std::int64_t planned) {
  const auto low = static_cast<std::uint32_t>(counter) - static_cast<std::uint32_t>(planned);
  return planned + static_cast<std::int32_t>(low);
}

}  // namespace

MotionTask::MotionTask(const MachineDescription& machine, units::Hertz clock,
                       drivers::StepGenerator& step_generator, drivers::EndStops& end_stops,
                       const OptionalParts& parts)
    : machine_(machine),
      clock_(clock),
      step_generator_(step_generator),
      end_stops_(end_stops),
      planner_(machine.limits, timing_of(machine, clock),
               motion::kinematics::Chosen(machine.kinematics)),
      shaping_(parts.shaping),
      levelling_(parts.levelling),
      pace_(step_generator, clock, lines_under_way + (shapes() ? shaped_lines : 0)) {
  if (motion::backlash_in_image) planner_.set_backlash(parts.backlash);
}

bool MotionTask::start() {
  step_generator_.acknowledge_stop();
  const auto floor = (std::uint64_t{rate_floor_millihertz} << 32) / 1000 / clock_.count();
  step_generator_.configure(guards_of(machine_, clock_), static_cast<std::uint32_t>(floor));
  if constexpr (units::most_tools > 1) {
    if (const auto second = second_guard_of(machine_, clock_)) {
      step_generator_.configure_second_extruder(*second);
    }
  }
  const std::uint64_t filter =
      std::uint64_t{end_stop_filter_ns} * clock_.count() / nanoseconds_per_second;
  std::uint8_t inputs = end_stops_of(machine_.limits);
  if (levels()) inputs = static_cast<std::uint8_t>(inputs | probe_input());
  std::uint8_t low = 0;
  if (filament_in_image && machine_.filament_sensor != nullptr) {
    const auto sensor = static_cast<std::uint8_t>(1u << machine_.filament_sensor->input);
    inputs = static_cast<std::uint8_t>(inputs | sensor);
    if (machine_.filament_sensor->low_is_out) low = sensor;
  }
  end_stops_.configure(
      {.enabled = inputs,
       .active_low = low,
       .filter_cycles = static_cast<std::uint16_t>(std::max<std::uint64_t>(filter, 1))});
  step_generator_.stop();  // update() learns where a program before this one has left the axes
  step_generator_.enable_stop_interrupt(true);
  constexpr auto watchdog_ms = static_cast<std::uint32_t>(task_timing::motion_watchdog.count());
  step_generator_.set_watchdog(clock_.count() / 1000 * watchdog_ms);
  pace_.set_limits(machine_.limits);
  if (levels()) restore_levelling();
  if (takes_up_backlash()) planner_.backlash().configure(*machine_.backlash, limits());
  if (!shapes()) return true;
  shaping_->set_timing(planner_.timing());
  shaping_->set_limits(machine_.limits);
  return restore_shaping();
}

bool MotionTask::restore_shaping() {
  return set_shaping(machine_.shaping.value_or(motion::ShapingSettings()));
}

bool MotionTask::set_shaping(const motion::ShapingSettings& settings) {
  return shaping_->configure(settings);
}

void MotionTask::update(const Now& now) {
  step_generator_.feed_watchdog();
  pace_.update(now.microseconds, step_generator_.moving());
}

bool MotionTask::plan(const Now& now) {
  // All else waits for the next pass.
  if (settle_stop(now.milliseconds)) return true;
  const bool leads = homing_.active() || probing();
  const bool works = line_is_whole() ? leads : planner_.has_room();
  if (works) {
    units::happens<units::Event::planned_or_executed>();
    if (!line_is_whole()) {
      levelled() ? go_on_levelled() : go_on_with_chords();
    } else {
      lead_homing(now.milliseconds);
    }
  }
  pace_.set_homing(homing_.active() || probing());
  if (plan_is_done() && step_generator_.idle()) pace_.note_rest();
  return works;
}

// After every stop what was planned is void, and the planner learns where the axes are.
bool MotionTask::settle_stop(units::Milliseconds now) {
  if (!step_generator_.stopped()) {
    stopping_ = false;
    return false;
  }
  units::happens<units::Event::planned_or_executed>();
  const drivers::StepGenerator::Stop stop = step_generator_.stop_state();
  if (stop.emergency_input) {
    emergency_input_ = true;
    return true;
  }
  if (stop.watchdog) {
    watchdog_stop_ = true;
    return true;
  }
  planner_.clear();
  if (shapes()) shaping_->clear();
  chords_.cancel();
  if (levels()) levelling_->line.cancel();
  lines_before_ = 0;
  units::PerAxis<std::int64_t> steps = planner_.position_steps();
  units::LoopBound<units::axis_count> axes;
  for (std::size_t i = 0; i < units::axis_count; ++i) {
    axes.next();
    steps[i] = unwrapped(stop.positions[i], steps[i] + lead(i)) - lead(i);
  }
  planner_.set_position_steps(steps);
  if (levelled()) find_levelled_place();
  stopped_by_end_stop_ = stop.end_stops != 0;
  rings_until_ = now + ringing_time;
  ++position_jumps_;
  step_generator_.acknowledge_stop();
  return true;
}

std::expected<void, motion::Fault> MotionTask::append(const motion::LineMove& move) {
  if (levelled() && !move.of_motors) return append_levelled(move);
  return kinematics().straight() || move.of_motors ? append_line(move) : append_chords(move);
}

std::expected<void, motion::Fault> MotionTask::append_line(const motion::LineMove& move) {
  const auto accepted = planner_.append(move, pace_.time());
  pace_.note_line(move.feedrate);
  if (accepted && !(motors_on_ == units::AxisSet::all())) {
    enable_motors(units::AxisSet::all(), true);
  }
  return accepted;
}

bool MotionTask::at_rest() const {
  return plan_is_done() && line_is_whole() && step_generator_.idle() && !stopping_ &&
         !homing_.active() && !probing() && !step_generator_.stopped();
}

void MotionTask::quick_stop() {
  homing_.cancel();
  chords_.cancel();
  if (levels()) {
    levelling_->probing.cancel();
    levelling_->line.cancel();
  }
  located_ = {};  // a motor that stops dead may lose steps
  stopping_ = true;
  step_generator_.stop();
}

void MotionTask::shut_down() {
  quick_stop();
  planner_.clear();
  if (shapes()) shaping_->clear();
  enable_motors(units::AxisSet::all(), false);
}

void MotionTask::enable_motors(units::AxisSet axes, bool enabled) {
  for (const units::Axis axis : all_axes) {
    if (!axes.contains(axis)) continue;
    step_generator_.enable_motor(axis, enabled);
    if (enabled) {
      motors_on_.insert(axis);
    } else {
      motors_on_.remove(axis);
      note_lost(axis);
    }
  }
}

void MotionTask::select_extruder(std::size_t extruder) {
  if constexpr (units::most_tools > 1) {
    constexpr units::Axis e = units::Axis::e;
    if (extruder == extruder_[0]) return;
    units::AxisSet motor;
    motor.insert(e);
    enable_motors(motor, false);
    filament_[0][extruder_[0]] = planner_.position()[index_of(e)];
    extruder_.fill(static_cast<std::uint8_t>(extruder));
    step_generator_.select_extruder(extruder);
    planner_.set_extruder_position(filament_[0][extruder]);
    // The same as its counter has, but where M92 has changed the steps since.
    const auto steps = static_cast<std::int32_t>(planner_.position_steps()[index_of(e)]);
    static_cast<void>(step_generator_.set_position(e, steps));
  }
}

// Where the axis is now is not known exactly, nor where others are that its motor moves.
void MotionTask::note_lost(units::Axis axis) {
  if (kinematics().identity() || axis == units::Axis::e) {
    located_.remove(axis);
  } else {
    located_ = {};
  }
}

}  // namespace application
