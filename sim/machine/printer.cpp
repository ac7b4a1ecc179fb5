// SPDX-License-Identifier: Apache-2.0
// Builds the printer that a machine description describes.
#include "sim/machine/printer.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "sim/machine/board_signals.hpp"
#include "sim/machine/printer_parts.hpp"
#include "sim/machine/surroundings.hpp"

namespace machine {

namespace {

// Steppers are chosen with this reserve of torque and of speed.
constexpr double torque_reserve = 8.0;
constexpr double speed_reserve = 2.0;
// Ceramic capacitors of the simulated board: 10 % of their nominal value.
constexpr double capacitor_tolerance = 0.1;
constexpr std::size_t extruder = 3;

// 0 to 1, the same with every standard library.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

plants::AxisProperties properties_of(const AxisDescription& axis, bool has_frame) {
  plants::AxisProperties properties;
  properties.steps_per_mm = axis.steps_per_mm;
  properties.torque_acceleration = torque_reserve * axis.max_acceleration_mm_s2 * axis.steps_per_mm;
  properties.speed_limit = speed_reserve * axis.max_speed_mm_s * axis.steps_per_mm;
  if (axis.travel_mm && has_frame) {
    properties.lower_frame = std::llround(-Mechanism::lower_frame_mm * axis.steps_per_mm);
    properties.upper_frame =
        std::llround((*axis.travel_mm + Mechanism::upper_frame_mm) * axis.steps_per_mm);
  }
  return properties;
}

devices::ThermistorInputProperties properties_of(const HeaterDescription& heater,
                                                 const ConverterDescription& converter,
                                                 std::uint64_t seed) {
  std::mt19937_64 random(seed);
  devices::ThermistorInputProperties properties;
  properties.thermistor = {heater.resistance_25c_ohms, heater.beta_k};
  properties.capacitor_farads =
      converter.capacitor_nf * 1e-9 * (1 + capacitor_tolerance * (2 * uniform(random) - 1));
  properties.reference_low_ohms = converter.reference_low_ohms;
  properties.reference_high_ohms = converter.reference_high_ohms;
  properties.supply_volts = converter.supply_v;
  properties.threshold_volts = converter.threshold_v;
  properties.pulls = sensor_pulls();
  return properties;
}

}  // namespace

Printer::HeatedPart::HeatedPart(const HeaterDescription& description,
                                const ConverterDescription& converter, double start_c,
                                std::uint64_t seed, sim::Simulation& simulation)
    : block(description.block, ambient_celsius, start_c),
      thermistor(
          properties_of(description, converter, seed),
          [this](double seconds) { return block.sensor_celsius(seconds); }, seed),
      gate(description.heater_channel, simulation.rate(), block),
      sensor(description.sensor_channel, simulation.rate(), thermistor,
             simulation.chip().inputs()) {
  simulation.attach(gate, {sim::OutputPins::heater_pin(description.heater_channel).word |
                           sim::OutputPins::heater_supply_pin().word});
  simulation.attach(sensor, sim::OutputPins::sensor_pins(description.sensor_channel));
}

Printer::Printer(const Description& description, const PrinterOptions& options,
                 sim::Simulation& simulation)
    : description_(description),
      simulation_(simulation),
      serial_line_(
          simulation.rate(), options.baud, simulation.chip().inputs(),
          {options.faults.corrupted_bytes, options.faults.corrupted_replies, options.seed}),
      hotend_(description.hotend, description.converter, options.hotend_start_c, options.seed + 1,
              simulation),
      bed_(description.bed, description.converter, options.bed_start_c, options.seed + 2,
           simulation),
      second_hotend_(make_second_hotend(options)),
      fan_(simulation.rate(),
           [this](double seconds, double speed) {
             hotend_.block.set_fan(seconds, speed);
             bed_.block.set_fan(seconds, speed);
             if (second_hotend_) second_hotend_->block.set_fan(seconds, speed);
           }),
      fault_injector_(std::make_unique<FaultInjector>(options.faults, *this)) {
  const double steps_per_mm = description.axes[extruder].steps_per_mm;
  extrusions_.push_back(
      std::make_unique<Extrusion>(steps_per_mm, simulation.rate(), hotend_.block));
  if (second_hotend_) {
    extrusions_.push_back(
        std::make_unique<Extrusion>(steps_per_mm, simulation.rate(), second_hotend_->block));
  }
  make_axes(options);
  attach_all();
}

Printer::~Printer() = default;

std::unique_ptr<Printer::HeatedPart> Printer::make_second_hotend(
    const PrinterOptions& options) const {
  if (!description_.second_tool) return nullptr;
  return std::make_unique<HeatedPart>(description_.second_tool->hotend, description_.converter,
                                      options.hotend_start_c, options.seed + 3, simulation_);
}

// A printer is switched on wherever the last print left it; here not far from the end stops, so
// that homing does not take long.
std::array<std::int64_t, axis_count> Printer::start_positions(std::uint64_t seed) const {
  std::mt19937_64 random(seed);
  Mechanism::Place numbers{};
  for (double& number : numbers) number = uniform(random);
  const Mechanism& mechanism = *description_.mechanism;
  const Mechanism::Place motors = mechanism.motors_of(mechanism.start(numbers));
  std::array<std::int64_t, axis_count> positions{};
  for (std::size_t i = 0; i < motors.size(); ++i) {
    positions[i] = std::llround(motors[i] * description_.axes[i].steps_per_mm);
  }
  return positions;
}

void Printer::make_axes(const PrinterOptions& options) {
  const std::array<std::int64_t, axis_count> start = start_positions(options.seed);
  const Mechanism& mechanism = *description_.mechanism;
  sim::InputPins& inputs = simulation_.chip().inputs();
  for (std::size_t i = 0; i < axis_count; ++i) make_motor(i, description_.axes[i], start[i]);
  if (description_.second_tool) {
    AxisDescription axis = description_.axes[extruder];
    axis.driver = description_.second_tool->driver;
    make_motor(axis_count, axis, 0);
  }
  for (std::size_t i = 0; i < axis_count; ++i) {
    const AxisDescription& axis = description_.axes[i];
    if (!axis.end_stop) continue;
    const devices::SwitchPlace place = mechanism.end_stop(i, axis.steps_per_mm);
    end_stops_.push_back(
        std::make_unique<devices::EndStop>(place, *axis.end_stop, simulation_.rate(), inputs, start,
                                           options.faults.end_stops[i], options.seed + i));
    for (std::size_t motor = 0; motor < axis_count; ++motor) {
      if (place.weights[motor] != 0) motors_[motor]->add_listener(*end_stops_.back());
    }
  }
  make_probe(start, options.faults);
  for (std::size_t i = 0; i < extrusions_.size(); ++i) {
    motors_[extruder + i]->add_listener(*extrusions_[i]);
  }
  if (mechanism.is_cartesian()) return;
  frame_ = std::make_unique<Frame>(*this);
  for (std::size_t i = 0; i < axis_count; ++i) motors_[i]->add_listener(*frame_);
}

void Printer::make_motor(std::size_t index, const AxisDescription& axis, std::int64_t start) {
  const bool has_frame = description_.mechanism->is_cartesian();
  axes_[index] = std::make_unique<plants::Axis>(properties_of(axis, has_frame), start);
  motors_[index] =
      std::make_unique<devices::MotorDriver>(index, axis.driver, simulation_.rate(), *axes_[index]);
}

void Printer::make_probe(const std::array<std::int64_t, axis_count>& start,
                         const FaultPlan& faults) {
  if (!description_.probe) {
    if (faults.probe == devices::EndStopFault::none) return;
    throw std::invalid_argument("a fault of the probe, but the machine has no [probe]");
  }
  const ProbeDescription& probe = *description_.probe;
  const auto triggers = [this, &probe](const std::array<std::int64_t, axis_count>& positions) {
    Mechanism::Place motors{};
    for (std::size_t i = 0; i < motors.size(); ++i) {
      motors[i] = static_cast<double>(positions[i]) / description_.axes[i].steps_per_mm;
    }
    const Mechanism::Place nozzle = description_.mechanism->place_of(motors);
    const double bed = description_.bed_surface.height(nozzle[0] + probe.offset_mm[0],
                                                       nozzle[1] + probe.offset_mm[1]);
    return nozzle[2] + probe.offset_mm[2] <= bed;
  };
  probe_ = std::make_unique<devices::Probe>(probe.input, simulation_.chip().inputs(), start,
                                            triggers, faults.probe);
  for (std::size_t i = 0; i < 3; ++i) motors_[i]->add_listener(*probe_);
}

Mechanism::Place Printer::motors_mm() const {
  return {axes_[0]->position_mm(), axes_[1]->position_mm(), axes_[2]->position_mm()};
}

std::uint64_t Printer::frame_steps(std::size_t axis) const {
  return axes_[axis]->frame_steps() + (frame_ && axis < axis_count ? frame_->steps(axis) : 0);
}

void Printer::attach_all() {
  for (std::size_t i = 0; i < motors(); ++i) {
    simulation_.attach(*motors_[i], sim::OutputPins::motor_pins(i));
  }
  for (const auto& end_stop : end_stops_) simulation_.attach(*end_stop, {});
  simulation_.attach(serial_line_, sim::OutputPins::transmit_pin());
  simulation_.attach(fan_, sim::OutputPins::fan_pin());
  for (const auto& extrusion : extrusions_) simulation_.attach(*extrusion, {});
  simulation_.attach(*fault_injector_, {});
}

void Printer::add_step_listener(devices::StepListener& listener) {
  for (std::size_t i = 0; i < motors(); ++i) {
    motors_[i]->add_listener(listener, sim::Activity::host_and_report);
  }
}

}  // namespace machine
