// SPDX-License-Identifier: Apache-2.0
// Lines in while there is room, segments out as soon as they are given, and the time
// that they take.
#include "benchmark/planner_work.hpp"

#include "application/coordinates.hpp"
#include "benchmark/text_lines.hpp"
#include "gcode/parser.hpp"
#include "machine/machine.hpp"

namespace benchmark {

namespace {

constexpr units::Hertz clock{50'000'000};
constexpr units::Hertz fastest_steps{500'000};  // as with an A4988
constexpr units::Microseconds look_interval{1'000};

motion::StepTiming timing() {
  motion::StepTiming timing{.clock = clock};
  timing.max_step_rate.fill(fastest_steps);
  return timing;
}

std::uint32_t folded(std::uint64_t value) {
  return static_cast<std::uint32_t>(value) ^ static_cast<std::uint32_t>(value >> 32);
}

}  // namespace

PlannerWork::PlannerWork() : planner_(machine::machine.limits, timing()) {}

void PlannerWork::prepare(std::string_view text) {
  application::Coordinates coordinates;
  TextLines lines(text);
  while (count_ < most_moves) {
    const auto line = lines.next();
    if (!line) break;
    const auto command = gcode::parse(*line);
    if (!command || !(command->is('G', 0) || command->is('G', 1))) continue;
    coordinates.take_feedrate(*command);
    const auto target = coordinates.target_of(*command);
    for (const auto axis : {units::Axis::x, units::Axis::y, units::Axis::z, units::Axis::e}) {
      coordinates.set_logical(axis, target[units::index_of(axis)]);
    }
    moves_[count_++] = {.target = target, .feedrate = coordinates.feedrate()};
  }
  if (count_ != 0) planner_.set_position(moves_[0].target);
}

ProcessorResult PlannerWork::run(std::uint32_t iterations) {
  ProcessorResult result;
  for (std::uint32_t i = 0; i < iterations; ++i) {
    for (std::size_t move = 1; move < count_; ++move) append(moves_[move], result);
    for (std::size_t move = count_; move-- > 1;) append(moves_[move - 1], result);
  }
  planner_.flush();
  while (!planner_.empty()) {
    if (!take_segments(result)) now_ += look_interval;
  }
  return result;
}

void PlannerWork::append(const motion::LineMove& move, ProcessorResult& result) {
  while (!planner_.has_room()) {
    if (!take_segments(result)) now_ += look_interval;
  }
  if (planner_.append(move, now_)) ++result.units;
}

bool PlannerWork::take_segments(ProcessorResult& result) {
  bool taken = false;
  while (const auto segment = planner_.next_segment(now_)) {
    taken = true;
    std::uint32_t word = segment->ticks ^ segment->line_ticks << 16;
    for (const std::int32_t steps : segment->steps) {
      word = 31 * word + static_cast<std::uint32_t>(steps);
    }
    word ^= folded(segment->rate) ^ folded(static_cast<std::uint64_t>(segment->acceleration));
    result.checksum = 31 * result.checksum + word;
  }
  return taken;
}

}  // namespace benchmark
