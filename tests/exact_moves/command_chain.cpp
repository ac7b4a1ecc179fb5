// SPDX-License-Identifier: Apache-2.0
// The bus of the step counter, and the passes that a line takes.
#include "tests/exact_moves/command_chain.hpp"

#include <cmath>

#include "machine/machine.hpp"
#include "platform/boot_loader.hpp"
#include "platform/bus.hpp"
#include "registers/step_generator_registers.hpp"
#include "registers/temperature_converter_registers.hpp"

namespace exact_moves {

namespace {

namespace generator = registers::step_generator;
namespace sense = registers::temperature_converter;

constexpr const application::MachineDescription& description = machine::machine;
constexpr thermal::ThermistorTable table{description.hotend.thermistor};
constexpr std::uint32_t picoseconds_per_ohm = thermal::picoseconds_per_ohm(
    description.converter.capacitor_picofarads, description.converter.supply_millivolts,
    description.converter.threshold_millivolts);
constexpr units::Hertz clock{8'000'000};
constexpr std::uint32_t queue_depth = 32;
// Of a thermistor of 100 kOhm at about 200 degrees, and of the references.
constexpr double counts_per_ohm = 6.03;
constexpr double thermistor_ohms = 600;

StepCounter* counter = nullptr;

template <class Register>
bool is_one_of(std::uint32_t address) {
  return address >= Register::address_of(0) && address < Register::address_of(Register::count);
}

std::uint32_t count_of(double ohms) { return static_cast<std::uint32_t>(ohms * counts_per_ohm); }

application::MachineDescription machine_with(
    const std::array<std::int32_t, axis_count>& steps_per_meter) {
  application::MachineDescription machine = description;
  for (std::size_t i = 0; i < axis_count; ++i) {
    machine.limits.axes[i].steps_per_meter = units::StepsPerMeter(steps_per_meter[i]);
  }
  return machine;
}

}  // namespace

StepCounter::StepCounter() { counter = this; }
StepCounter::~StepCounter() { counter = nullptr; }

std::uint32_t StepCounter::read(std::uint32_t address) {
  if (address == generator::Build::address) {
    return generator::Build{.axes = 5, .queue_depth = queue_depth}.encode();
  }
  if (address == generator::Status::address) {
    return generator::Status{.idle = true, .free = queue_depth}.encode();
  }
  if (address == generator::Scale::address) return 1u << 16;
  if (is_one_of<sense::Status>(address)) {
    return sense::Status{.state = sense::Status::State::ok, .conversions = conversions_ & 0xFFu}
        .encode();
  }
  if (is_one_of<sense::Thermistor>(address)) return count_of(thermistor_ohms);
  if (is_one_of<sense::ReferenceLow>(address)) return count_of(470);
  if (is_one_of<sense::ReferenceHigh>(address)) return count_of(10'000);
  return 0;
}

void StepCounter::write(std::uint32_t address, std::uint32_t value) {
  words_[address] = value;
  if (address == generator::SegmentCommit::address) commit();
}

void StepCounter::commit() {
  const auto flags = generator::SegmentFlags::decode(words_[generator::SegmentFlags::address]);
  const std::uint32_t ticks = words_[generator::SegmentTicks::address];
  if (!flags.continues_line) {
    if (ticks_left_ != 0) ++broken_lines;
    ticks_left_ = words_[generator::SegmentLineTicks::address];
    for (std::size_t axis = 0; axis < axis_count; ++axis) {
      const std::int64_t count = words_[generator::SegmentSteps::address_of(axis)];
      if (count > ticks_left_) ++broken_lines;
      steps[axis] += (flags.backward >> axis & 1u) != 0 ? -count : count;
    }
  }
  if (ticks == 0 || ticks > ticks_left_) ++broken_lines;
  ticks_left_ -= ticks;
}

CommandChain::CommandChain(const std::array<std::int32_t, axis_count>& steps_per_meter)
    : machine_(machine_with(steps_per_meter)),
      converter_(clock),
      heater_control_(clock),
      motion_(machine_, clock, step_generator_, end_stops_),
      heat_(machine_, {table, table, picoseconds_per_ohm}, clock, converter_, heater_control_),
      executor_(machine_, motion_, heat_, fan_, link_, statistics_) {
  motion_.start();
  heat_.start();
  while (heat_.extrusion_is_cold()) pass();
}

void CommandChain::take(std::string_view line) {
  const std::string bytes = std::string(line) + '\n';
  link_.receive(bytes, now_.milliseconds);
  while (link_.waiting_lines() != 0) pass();
  collect_replies();
}

// So long that whatever is handed over is over.
void CommandChain::pass() {
  constexpr std::int64_t pass_ms = 200;
  now_.milliseconds += units::Milliseconds(pass_ms);
  now_.microseconds += units::Microseconds(pass_ms * 1000);
  counter_.convert();
  motion_.update(now_);
  motion_.plan(now_);
  link_.update(now_.milliseconds, executor_.activity());
  executor_.update(now_);
  motion_.refill(now_.microseconds);
  if (heat_.is_due(now_.milliseconds)) heat_.update(now_);
  for (auto bytes = link_.to_send(); !bytes.empty(); bytes = link_.to_send()) {
    replies_.append(bytes.begin(), bytes.end());
    link_.sent(bytes.size());
  }
}

void CommandChain::collect_replies() {
  std::size_t begin = 0;
  for (std::size_t end; (end = replies_.find('\n', begin)) != std::string::npos; begin = end + 1) {
    const std::string_view line(replies_.data() + begin, end - begin);
    if (line != "ok" && !line.starts_with("echo:busy")) notices.append(line).append("\n");
  }
  replies_.erase(0, begin);
}

}  // namespace exact_moves

namespace platform {

bool enter_boot_loader() { return false; }
std::uint32_t bus_read(std::uint32_t address) { return exact_moves::counter->read(address); }
void bus_write(std::uint32_t address, std::uint32_t value) {
  exact_moves::counter->write(address, value);
}

}  // namespace platform
