// SPDX-License-Identifier: Apache-2.0
// Registers, and the execution of segments.
#include "tools/planning/motion_model.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "platform/boot_loader.hpp"
#include "platform/bus.hpp"
#include "registers/end_stops_registers.hpp"
#include "registers/step_generator_registers.hpp"
#include "registers/temperature_converter_registers.hpp"
#include "tools/planning/cubic.hpp"
#include "units/axes.hpp"

namespace planning {

namespace {

namespace generator = registers::step_generator;
namespace sense = registers::temperature_converter;

constexpr std::size_t x = units::index_of(units::Axis::x), y = units::index_of(units::Axis::y),
                      z = units::index_of(units::Axis::z), e = units::index_of(units::Axis::e);
// Of a thermistor of 100 kOhm at about 200 degrees, and of the references.
constexpr double clocks_per_ohm = 6.03 / 8e6;  // and hertz
constexpr double hot_ohms = 600;
constexpr double one = 65536;  // of the override
// Layers are farther apart, in 10 nm; the rounded steps of three towers are nearer.
constexpr std::int64_t same_height = 2'000;

MotionModel* model = nullptr;

template <class Register>
bool is_one_of(std::uint32_t address) {
  return address >= Register::address_of(0) && address < Register::address_of(Register::count);
}

template <class Register>
std::size_t index_in(std::uint32_t address) {
  return (address - Register::address_of(0)) / 4;
}

std::uint32_t conversions_of(double seconds) {
  return static_cast<std::uint32_t>(seconds * 16) & 0xFFu;
}

bool is_of_generator(std::uint32_t address) { return address >> 12 == generator::base >> 12; }

}  // namespace

MotionModel::MotionModel(const motion::Limits& limits, const motion::kinematics::Any& kinematics,
                         double clock_hz)
    : kinematics_(kinematics), clock_hz_(clock_hz) {
  set_steps_per_mm(limits);
  place_end_stops(limits);
  words_[generator::Override::address / 4 % words_of_peripheral] = static_cast<std::uint32_t>(one);
  model = this;
}

MotionModel::~MotionModel() { model = nullptr; }

void MotionModel::set_steps_per_mm(const motion::Limits& limits) {
  for (std::size_t i = 0; i < motor_count; ++i) {
    steps_per_mm_[i] = limits.axes[std::min(i, e)].steps_per_meter.count() / 1000.0;
  }
}

void MotionModel::fit_probe(std::uint8_t input, units::Nanometers height) {
  constexpr double nanometers_per_mm = 1e6;
  probe_ = 1u << input;
  probe_distance_ =
      std::llround(static_cast<double>(height.count()) / nanometers_per_mm * steps_per_mm_[z]);
}

std::size_t MotionModel::level() {
  while (!begins_.empty() && begins_.front() <= now_) begins_.pop_front();
  return begins_.size();
}

std::uint32_t MotionModel::count_of(double ohms) const {
  return static_cast<std::uint32_t>(ohms * clocks_per_ohm * clock_hz_);
}

double MotionModel::segment_end() const { return begins_.empty() ? queue_end_ : begins_.front(); }

std::uint32_t MotionModel::closed_end_stops() const {
  std::uint32_t closed = 0;
  for (std::size_t i = 0; i < motor_count; ++i) closed |= distance_[i] <= 0 ? end_stop_[i] : 0;
  if (distance_[z] <= probe_distance_) closed |= probe_;
  return closed;
}

std::uint32_t MotionModel::read(std::uint32_t address) {
  if (is_of_generator(address)) return read_generator(address);
  if (address == registers::end_stops::Status::address) {
    return registers::end_stops::Status{.triggered = closed_end_stops()}.encode();
  }
  if (is_one_of<sense::Status>(address)) {
    return sense::Status{.state = sense::Status::State::ok,
                         .conversions = conversions_of(now_ / clock_hz_)}
        .encode();
  }
  if (is_one_of<sense::Thermistor>(address)) return count_of(hot_ohms);
  if (is_one_of<sense::ReferenceLow>(address)) return count_of(470);
  if (is_one_of<sense::ReferenceHigh>(address)) return count_of(10'000);
  return 0;
}

std::uint32_t MotionModel::read_generator(std::uint32_t address) {
  if (address == generator::Status::address) {
    const auto queued = static_cast<std::uint32_t>(level());
    const bool moving = queue_end_ > now_;
    return generator::Status{.moving = moving,
                             .idle = !moving,
                             .stopped = stopped(),
                             .level = queued,
                             .free = static_cast<std::uint32_t>(queue_depth) - queued}
        .encode();
  }
  if (address == generator::Build::address) {
    return generator::Build{.axes = motor_count, .queue_depth = queue_depth}.encode();
  }
  if (address == generator::Errors::address) return 0;
  if (address == generator::Scale::address) return word(generator::Override::address);
  if (address == generator::StopCause::address) {
    return generator::StopCause{.end_stops = stop_cause_}.encode();
  }
  if (is_one_of<generator::StopPosition>(address)) {
    const std::size_t axis = index_in<generator::StopPosition>(address);
    return axis < motor_count ? static_cast<std::uint32_t>(position_[axis]) : 0;
  }
  if (is_one_of<generator::SnapshotPosition>(address)) {
    const std::size_t axis = index_in<generator::SnapshotPosition>(address);
    return axis < motor_count ? static_cast<std::uint32_t>(position_[axis]) : 0;
  }
  return word(address);
}

void MotionModel::write(std::uint32_t address, std::uint32_t value) {
  if (!is_of_generator(address)) return;
  words_[address / 4 % words_of_peripheral] = value;
  if (address == generator::SegmentCommit::address) commit();
  if (address == generator::Command::address) command(value);
  if (is_one_of<generator::Position>(address)) {
    const std::size_t axis = index_in<generator::Position>(address);
    if (axis < motor_count) position_[axis] = static_cast<std::int32_t>(value);
  }
}

void MotionModel::command(std::uint32_t value) {
  if (generator::Command::decode(value).acknowledge_stop) stop_time_ = never;
}

double MotionModel::wide(std::uint32_t low, std::uint32_t high) const {
  return static_cast<double>(
      std::bit_cast<std::int64_t>(std::uint64_t{word(high)} << 32 | word(low)));
}

// The queue of a segment that an end stop has ended is forgotten: what comes behind it until the
// stop is acknowledged is not executed.
void MotionModel::commit() {
  if (stop_time_ != never) return;
  const auto flags = generator::SegmentFlags::decode(word(generator::SegmentFlags::address));
  if (!flags.continues_line) begin_line(flags.backward, flags.stop_mask);
  if (queue_end_ < now_) {
    underruns_ += ends_motion_ ? 0 : 1;
    queue_end_ = now_;
  }
  const double begin = queue_end_;
  if (first_step_ < 0) first_step_ = begin;
  if (!flags.continues_line) record_layer(begin);
  const double rate = std::ldexp(
      wide(generator::SegmentRateLow::address, generator::SegmentRateHigh::address), -64);
  const double acceleration = std::ldexp(
      wide(generator::SegmentAccelerationLow::address, generator::SegmentAccelerationHigh::address),
      -84);
  const double jerk = std::ldexp(
      wide(generator::SegmentJerkLow::address, generator::SegmentJerkHigh::address), -84);
  const double floor = std::ldexp(word(generator::RateFloor::address), -32);
  const double ticks = word(generator::SegmentTicks::address);
  const double stop_after = line_.last_tick - line_.ticks_done;
  const double walked = std::min(ticks, stop_after);
  const double scale = word(generator::Override::address) / one;
  double base_clocks = 0;
  if (jerk == 0) {
    const double last_rate =
        std::max(std::sqrt(std::max(rate * rate + 2 * acceleration * walked, 0.0)), floor);
    base_clocks = 2 * walked / (std::max(rate, floor) + last_rate);
    record_peaks(rate, last_rate, acceleration, scale);
  } else {
    const Cubic course(rate, acceleration, jerk);
    base_clocks = course.clocks_of(walked);
    record_peaks(rate, course.rate(base_clocks), course.highest_acceleration(base_clocks), scale);
  }
  const double clocks = base_clocks / scale;
  line_.ticks_done += walked;
  begins_.push_back(begin);
  queue_end_ += clocks;
  moving_clocks_ += clocks;
  ends_motion_ = flags.ends_motion;
  if (line_.ticks_done < line_.last_tick) return;
  count_steps();
  if (line_.last_tick == line_.ticks && (line_.stop_mask & closed_end_stops()) == 0) return;
  stop_time_ = queue_end_;
  stop_cause_ = line_.stop_mask & closed_end_stops();
  ends_motion_ = true;
}

void MotionModel::begin_line(std::uint32_t backward, std::uint32_t stop_mask) {
  line_ = {.ticks = static_cast<double>(word(generator::SegmentLineTicks::address)),
           .stop_mask = stop_mask};
  for (std::size_t i = 0; i < motor_count; ++i) {
    const std::int64_t count = word(generator::SegmentSteps::address_of(i));
    line_.steps[i] = (backward >> i & 1u) != 0 ? -count : count;
  }
  line_.last_tick = tick_of_stop(line_);
  ++lines_;
}

// The first tick after which an end stop that ends the line is closed, or its last.
double MotionModel::tick_of_stop(const Line& line) const {
  double last = line.ticks;
  for (std::size_t i = 0; i < motor_count; ++i) {
    if ((line.stop_mask & end_stop_[i]) == 0) continue;
    const std::int64_t approach = approach_of(i, line.steps);
    if (distance_[i] <= 0) return 1;
    if (approach < distance_[i]) continue;
    const double part = static_cast<double>(distance_[i]) / static_cast<double>(approach);
    last = std::min(last, std::ceil(part * line.ticks));
  }
  if ((line.stop_mask & probe_) == 0) return last;
  const std::int64_t away = distance_[z] - probe_distance_, approach = approach_of(z, line.steps);
  if (away <= 0) return 1;
  if (approach < away) return last;
  const double part = static_cast<double>(away) / static_cast<double>(approach);
  return std::min(last, std::ceil(part * line.ticks));
}

// All of them, or those until the end stop.
void MotionModel::count_steps() {
  const double part = line_.last_tick / line_.ticks;
  const double filament_before = filament_mm_[0] + filament_mm_[1];
  std::array<std::int64_t, motor_count> made = line_.steps;
  for (std::size_t i = 0; i < motor_count; ++i) {
    if (part < 1) made[i] = std::llround(static_cast<double>(line_.steps[i]) * part);
    position_[i] = static_cast<std::int32_t>(position_[i] + made[i]);
    (made[i] < 0 ? axes_[i].steps_backward : axes_[i].steps_forward) +=
        static_cast<std::uint64_t>(std::abs(made[i]));
    if (i >= e) filament_mm_[i - e] += static_cast<double>(made[i]) / steps_per_mm_[i];
  }
  for (std::size_t i = 0; i < motor_count; ++i) distance_[i] -= approach_of(i, made);
  if (!on_line) return;
  on_line(
      {.end_mm = place_mm(), .filament_mm = filament_mm_[0] + filament_mm_[1] - filament_before});
}

// A line that extrudes in the plane, at another height than those before.
void MotionModel::record_layer(double begin) {
  const bool prints = (line_.steps[e] > 0 || line_.steps[e + 1] > 0) &&
                      (line_.steps[x] != 0 || line_.steps[y] != 0);
  if (!prints || (kinematics_.has_own_z() && line_.steps[z] != 0)) return;
  constexpr double per_mm = 1e5;
  const double z_mm = place_mm()[z];
  const std::int64_t height = std::llround(z_mm * per_mm);
  if (!layers_.empty() &&
      std::abs(height - layer_height_) <= (kinematics_.has_own_z() ? 0 : same_height)) {
    return;
  }
  layer_height_ = height;
  layers_.push_back({.z_mm = z_mm, .begin_seconds = begin / clock_hz_});
}

void MotionModel::record_peaks(double rate, double end_rate, double acceleration, double scale) {
  for (std::size_t i = 0; i < motor_count; ++i) {
    const double share = static_cast<double>(std::abs(line_.steps[i])) / line_.ticks;
    const double hertz = std::max(rate, end_rate) * share * clock_hz_ * scale;
    const double change = std::abs(acceleration) * share * clock_hz_ * clock_hz_ * scale * scale;
    AxisPlan& axis = axes_[i];
    axis.max_step_rate_hz = std::max(axis.max_step_rate_hz, hertz);
    axis.max_speed_mm_per_s = std::max(axis.max_speed_mm_per_s, hertz / steps_per_mm_[i]);
    axis.max_acceleration_mm_per_s2 =
        std::max(axis.max_acceleration_mm_per_s2, change / steps_per_mm_[i]);
  }
}

}  // namespace planning

namespace platform {

bool enter_boot_loader() { return false; }
std::uint32_t bus_read(std::uint32_t address) { return planning::model->read(address); }
void bus_write(std::uint32_t address, std::uint32_t value) {
  planning::model->write(address, value);
}

}  // namespace platform
