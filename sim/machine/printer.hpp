// SPDX-License-Identifier: Apache-2.0
// The wiring diagram: the chip's pins, the devices on them, and the plants behind those.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "sim/devices/end_stop.hpp"
#include "sim/devices/fan_gate.hpp"
#include "sim/devices/heater_gate.hpp"
#include "sim/devices/motor_driver.hpp"
#include "sim/devices/probe.hpp"
#include "sim/devices/sensor_channel.hpp"
#include "sim/devices/serial_line.hpp"
#include "sim/machine/description.hpp"
#include "sim/machine/fault_plan.hpp"
#include "sim/plants/axis.hpp"
#include "sim/plants/heated_block.hpp"
#include "sim/simulation/simulation.hpp"

namespace machine {

struct PrinterOptions {
  std::uint32_t baud{};
  std::uint64_t seed = 1;
  double hotend_start_c{};
  double bed_start_c{};
  FaultPlan faults;
};

class Printer {
 public:
  Printer(const Description& description, const PrinterOptions& options,
          sim::Simulation& simulation);
  ~Printer();

  devices::SerialLine& serial_line() { return serial_line_; }
  // Of the axes, and behind them that of a second extruder.
  std::size_t motors() const { return description_.motors(); }
  const devices::MotorDriver& motor(std::size_t axis) const { return *motors_[axis]; }
  const plants::Axis& axis(std::size_t axis) const { return *axes_[axis]; }
  // To be called before the simulation runs.
  void add_step_listener(devices::StepListener& listener);
  // Of the tool, mm, by the motors' positions.
  Mechanism::Place place_mm() const { return description_.mechanism->place_of(motors_mm()); }
  Mechanism::Place motors_mm() const;
  // Steps with which an axis would have left the frame, by the motor that made them.
  std::uint64_t frame_steps(std::size_t axis) const;
  // True temperatures of the blocks.
  double hotend_c() const { return hotend_.block.celsius(simulation_.seconds()); }
  // Only where there is one.
  double second_hotend_c() const { return second_hotend_->block.celsius(simulation_.seconds()); }
  double bed_c() const { return bed_.block.celsius(simulation_.seconds()); }
  const Description& description() const { return description_; }

 private:
  struct HeatedPart {
    HeatedPart(const HeaterDescription& description, const ConverterDescription& converter,
               double start_c, std::uint64_t seed, sim::Simulation& simulation);
    plants::HeatedBlock block;
    devices::ThermistorInput thermistor;
    devices::HeaterGate gate;
    devices::SensorChannel sensor;
  };
  class FaultInjector;
  class Extrusion;
  class Frame;

  void make_axes(const PrinterOptions& options);
  void make_probe(const std::array<std::int64_t, axis_count>& start, const FaultPlan& faults);
  void make_motor(std::size_t index, const AxisDescription& axis, std::int64_t start);
  std::unique_ptr<HeatedPart> make_second_hotend(const PrinterOptions& options) const;
  std::array<std::int64_t, axis_count> start_positions(std::uint64_t seed) const;
  void attach_all();

  Description description_;
  sim::Simulation& simulation_;
  devices::SerialLine serial_line_;
  std::array<std::unique_ptr<plants::Axis>, most_motors> axes_;
  std::array<std::unique_ptr<devices::MotorDriver>, most_motors> motors_;
  std::vector<std::unique_ptr<devices::EndStop>> end_stops_;
  std::unique_ptr<devices::Probe> probe_;
  std::unique_ptr<Frame> frame_;  // where motors are not axes
  HeatedPart hotend_;
  HeatedPart bed_;
  std::unique_ptr<HeatedPart> second_hotend_;
  devices::FanGate fan_;
  std::vector<std::unique_ptr<Extrusion>> extrusions_;
  std::unique_ptr<FaultInjector> fault_injector_;
};

}  // namespace machine
