// SPDX-License-Identifier: Apache-2.0
// Driver of the step generator: the order of register accesses that hands a segment over whole.
#include "drivers/step_generator.hpp"

#include <algorithm>

#include "platform/bus.hpp"
#include "registers/step_generator_registers.hpp"
#include "units/loop_bound.hpp"
#include "units/magnitude.hpp"

namespace drivers {
namespace {

namespace registers = ::registers::step_generator;

constexpr std::size_t e = units::index_of(units::Axis::e);

std::uint32_t backward_axes(const motion::Segment& segment) {
  std::uint32_t backward = 0;
  units::LoopBound<units::axis_count> axes;
  for (std::size_t axis = 0; axis < units::axis_count; ++axis) {
    axes.next();
    if (segment.steps[axis] < 0) backward |= 1u << axis;
  }
  return backward;
}

// The bit of E moves to the extruder's.
std::uint32_t on_hardware(std::uint32_t axes, std::size_t extruder_axis) {
  if constexpr (units::most_tools == 1) return axes;
  const std::uint32_t extruder = axes >> e & 1u;
  return (axes & ~(1u << e)) | extruder << extruder_axis;
}

// The path: only with the first segment of a line, the step generator keeps it for the others.
void write_line(const motion::Segment& segment, std::size_t hardware_axes,
                std::size_t extruder_axis) {
  platform::write(registers::SegmentLineTicks{segment.line_ticks});
  units::LoopBound<registers::SegmentSteps::count> axes;
  for (std::size_t axis = 0; axis < hardware_axes; ++axis) {
    axes.next();
    std::uint32_t steps = axis < units::axis_count ? units::magnitude(segment.steps[axis]) : 0;
    if constexpr (units::most_tools > 1) {
      if (axis >= e) steps = axis == extruder_axis ? units::magnitude(segment.steps[e]) : 0;
    }
    platform::write(axis, registers::SegmentSteps{steps});
  }
}

// The course of the rate along it.
void write_course(const motion::Segment& segment) {
  platform::write(registers::SegmentTicks{segment.ticks});
  platform::write(registers::SegmentRate{segment.rate});
  platform::write(registers::SegmentAcceleration{segment.acceleration});
  platform::write(registers::SegmentJerk{segment.jerk});
}

void set_guard(std::size_t axis, const GuardTimings& guard) {
  platform::write(axis, registers::PulseGuard{
                            .high = guard.high, .low = guard.low, .both_edges = guard.both_edges});
  platform::write(axis, registers::DirectionGuard{.setup = guard.direction_setup,
                                                  .hold = guard.direction_hold});
}

// Whether anything was refused since the last call.
bool refused() {
  if (platform::read<registers::Errors>().encode() == 0) return false;
  platform::write(registers::Command{.clear_errors = true});
  return true;
}

}  // namespace

void StepGenerator::configure(const units::PerAxis<GuardTimings>& guards,
                              std::uint32_t rate_floor) {
  hardware_axes_ = platform::read<registers::Build>().axes;
  const std::size_t axes = std::min(hardware_axes_, units::axis_count);
  units::LoopBound<units::axis_count> configured;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    configured.next();
    set_guard(axis, guards[axis]);
  }
  platform::write(registers::RateFloor{rate_floor});
  permit_motion(true);
}

void StepGenerator::configure_second_extruder(const GuardTimings& guard) {
  set_guard(e + 1, guard);
}

void StepGenerator::select_extruder(std::size_t extruder) {
  extruder_.fill(static_cast<std::uint8_t>(extruder));
}

std::uint32_t StepGenerator::queue_depth() const {
  return platform::read<registers::Build>().queue_depth;
}

std::uint32_t StepGenerator::free_segments() const {
  return platform::read<registers::Status>().free;
}

std::uint32_t StepGenerator::queued_segments() const {
  return platform::read<registers::Status>().level;
}

bool StepGenerator::append(const motion::Segment& segment) {
  const auto status = platform::read<registers::Status>();
  if (status.free == 0 || status.stopped || status.braking) return false;
  platform::write(
      registers::SegmentFlags{.backward = on_hardware(backward_axes(segment), hardware_axis(e)),
                              .continues_line = segment.continues_line,
                              .ends_motion = segment.ends_motion,
                              .stop_on_change = segment.stop_on_change,
                              .stop_on_release = segment.stop_on_release,
                              .stop_brakes = segment.stop_brakes,
                              .waits_for_start = segment.waits_for_start,
                              .stop_mask = segment.stop_mask,
                              .ahead = segment.start.ahead.bits(),
                              .behind = segment.start.behind.bits()});
  if (!segment.continues_line) write_line(segment, hardware_axes_, hardware_axis(e));
  write_course(segment);
  platform::write(registers::SegmentCommit{});
  return !refused();
}

void StepGenerator::permit_motion(bool permitted) {
  auto control = platform::read<registers::Control>();
  control.run = permitted;
  platform::write(control);
}

void StepGenerator::flush() { platform::write(registers::Command{.flush = true}); }

bool StepGenerator::stretches_time() const { return true; }

void StepGenerator::set_override(std::uint32_t scale_65536ths) {
  platform::write(registers::Override{scale_65536ths});
}

void StepGenerator::set_override_percent(std::uint32_t percent) {
  constexpr std::uint32_t one = 65536, hundred = 100;
  set_override((percent * one + hundred / 2) / hundred);
}

void StepGenerator::set_slopes(std::uint32_t override_slope, std::uint32_t brake_slope) {
  platform::write(registers::OverrideSlope{override_slope});
  platform::write(registers::BrakeSlope{brake_slope});
}

std::uint32_t StepGenerator::scale() const { return platform::read<registers::Scale>().scale; }

bool StepGenerator::held() const { return platform::read<registers::Status>().held; }

void StepGenerator::start() { platform::write(registers::Command{.start = true}); }

bool StepGenerator::waiting() const { return platform::read<registers::Status>().waiting; }

void StepGenerator::set_watchdog(std::uint32_t clocks) {
  platform::write(registers::Watchdog{clocks});
}

void StepGenerator::feed_watchdog() { platform::write(registers::Command{.feed_watchdog = true}); }

bool StepGenerator::moving() const { return platform::read<registers::Status>().moving; }

bool StepGenerator::idle() const { return platform::read<registers::Status>().idle; }

StepGenerator::Snapshot StepGenerator::snapshot() {
  platform::write(registers::Command{.snapshot = true});
  Snapshot result;
  for (std::size_t axis = 0; axis < units::axis_count; ++axis) {
    result.positions[axis] = platform::read<registers::SnapshotPosition>(hardware_axis(axis)).steps;
  }
  result.clock = platform::read<registers::SnapshotTime>().clocks;
  return result;
}

bool StepGenerator::set_position(units::Axis axis, std::int32_t steps) {
  platform::write(hardware_axis(units::index_of(axis)), registers::Position{steps});
  return !refused();
}

void StepGenerator::stop() { platform::write(registers::Command{.stop = true}); }

void StepGenerator::brake() { platform::write(registers::Command{.brake = true}); }

StepGenerator::Stop StepGenerator::stop_state() const {
  Stop result;
  const auto status = platform::read<registers::Status>();
  result.stopped = status.stopped;
  result.braking = status.braking;
  if (!result.stopped && !result.braking) return result;
  const auto cause = platform::read<registers::StopCause>();
  result.end_stops = static_cast<std::uint8_t>(cause.end_stops);
  result.emergency_input = cause.emergency_input;
  result.software = cause.software;
  result.watchdog = cause.watchdog;
  result.software_brake = cause.software_brake;
  units::LoopBound<units::axis_count> axes;
  for (std::size_t axis = 0; axis < units::axis_count; ++axis) {
    axes.next();
    result.positions[axis] = platform::read<registers::StopPosition>(hardware_axis(axis)).steps;
  }
  result.clock = platform::read<registers::StopTime>().clocks;
  return result;
}

bool StepGenerator::stopped() const { return platform::read<registers::Status>().stopped; }

void StepGenerator::acknowledge_stop() {
  platform::write(registers::Command{.acknowledge_stop = true});
}

void StepGenerator::enable_motor(units::Axis axis, bool enabled) {
  auto motors = platform::read<registers::MotorEnable>();
  const std::uint32_t mask = 1u << hardware_axis(units::index_of(axis));
  motors.axes = enabled ? motors.axes | mask : motors.axes & ~mask;
  platform::write(motors);
}

bool StepGenerator::motor_enabled(units::Axis axis) const {
  return ((platform::read<registers::MotorEnable>().axes >> hardware_axis(units::index_of(axis))) &
          1u) != 0;
}

void StepGenerator::enable_queue_interrupt(std::uint32_t threshold) {
  auto control = platform::read<registers::Control>();
  control.queue_threshold = threshold;
  control.queue_interrupt_enable = true;
  platform::write(control);
}

void StepGenerator::disable_queue_interrupt() {
  auto control = platform::read<registers::Control>();
  control.queue_interrupt_enable = false;
  platform::write(control);
}

void StepGenerator::enable_stop_interrupt(bool enabled) {
  auto control = platform::read<registers::Control>();
  control.stop_interrupt_enable = enabled;
  platform::write(control);
}

StepGenerator::Counters StepGenerator::counters() const {
  Counters result;
  result.segments = platform::read<registers::SegmentsExecuted>().count;
  result.underruns = platform::read<registers::Underruns>().count;
  result.stall_clocks = platform::read<registers::Stalls>().clocks;
  for (std::size_t axis = 0; axis < units::axis_count; ++axis) {
    result.axis_stall_clocks[axis] =
        platform::read<registers::AxisStalls>(hardware_axis(axis)).clocks;
  }
  result.max_level = platform::read<registers::MaxLevel>().segments;
  return result;
}

}  // namespace drivers
