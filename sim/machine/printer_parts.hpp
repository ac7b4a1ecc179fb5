// SPDX-License-Identifier: Apache-2.0
// Parts of the printer that are connected to no pin: filament that carries heat away, its frame,
// and planned faults.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "sim/machine/printer.hpp"

namespace machine {

// Cold filament comes in with the extruder's steps and leaves hot.
class Printer::Extrusion : public sim::Device, public devices::StepListener {
 public:
  Extrusion(double steps_per_mm, sim::ClockRate rate, plants::HeatedBlock& hotend)
      : rate_(rate), hotend_(hotend), steps_per_mm_(steps_per_mm) {
    next_wake_ = rate_.clocks(interval_seconds);
  }

  void stepped(const devices::StepEdge& edge) override { position_ = edge.position; }

  void wake(sim::Clock now) override {
    next_wake_ = now + rate_.clocks(interval_seconds);
    const double length_mm = static_cast<double>(position_ - position_before_) / steps_per_mm_;
    position_before_ = position_;
    const double flow = filament_square_mm * std::max(length_mm, 0.0) / interval_seconds;
    hotend_.set_extrusion(rate_.seconds(now), std::round(flow / flow_step) * flow_step);
  }

 private:
  static constexpr double interval_seconds = 0.2;
  static constexpr double filament_diameter_mm = 1.75;
  static constexpr double filament_square_mm =
      std::numbers::pi / 4 * filament_diameter_mm * filament_diameter_mm;
  static constexpr double flow_step =
      0.25;  // mm^3/s: finer ones change no temperature that matters

  sim::ClockRate rate_;
  plants::HeatedBlock& hotend_;
  double steps_per_mm_;
  std::int64_t position_ = 0, position_before_ = 0;
};

// Counts the steps beyond the frame where several motors move an axis. They are not held there.
class Printer::Frame : public devices::StepListener {
 public:
  explicit Frame(const Printer& printer) : printer_(printer) {}

  void stepped(const devices::StepEdge& edge) override {
    Mechanism::Place travel{};
    for (std::size_t i = 0; i < travel.size(); ++i) {
      travel[i] = printer_.description_.axes[i].travel_mm.value_or(0);
    }
    const Mechanism& mechanism = *printer_.description_.mechanism;
    if (mechanism.is_beyond_frame(printer_.motors_mm(), travel)) ++steps_[edge.axis];
  }
  std::uint64_t steps(std::size_t axis) const { return steps_[axis]; }

 private:
  const Printer& printer_;
  std::array<std::uint64_t, axis_count> steps_{};
};

// Injects faults at their times.
class Printer::FaultInjector : public sim::Device {
 public:
  FaultInjector(FaultPlan plan, Printer& printer)
      : plan_(std::move(plan)),
        rate_(printer.simulation_.rate()),
        printer_(printer),
        line_(printer.serial_line_) {
    const auto of_second = [](const auto& fault) { return fault.where == Heated::second_hotend; };
    if (!printer_.second_hotend_ && (std::ranges::any_of(plan_.sensors, of_second) ||
                                     std::ranges::any_of(plan_.beads, of_second) ||
                                     std::ranges::any_of(plan_.heaters, of_second) ||
                                     std::ranges::any_of(plan_.capacitors, of_second))) {
      throw std::invalid_argument("--fault: this machine has no second hotend");
    }
    wake(0);
  }

  void wake(sim::Clock now) override {
    const double seconds = rate_.seconds(now);
    double next = std::numeric_limits<double>::infinity();
    for (TimedSensorFault& fault : plan_.sensors) {
      if (is_due(fault.seconds, seconds, next)) {
        part(fault.where).sensor.set_fault(now, fault.fault);
        fault.seconds = std::numeric_limits<double>::infinity();
      }
    }
    for (TimedBeadFault& fault : plan_.beads) {
      if (is_due(fault.seconds, seconds, next)) {
        part(fault.where).block.set_bead_fault(seconds, fault.fault);
        fault.seconds = std::numeric_limits<double>::infinity();
      }
    }
    for (TimedHeaterFault& fault : plan_.heaters) {
      if (is_due(fault.seconds, seconds, next)) {
        part(fault.where).block.set_fault(seconds, fault.fault);
        fault.seconds = std::numeric_limits<double>::infinity();
      }
    }
    for (TimedCapacitorFault& fault : plan_.capacitors) {
      if (is_due(fault.seconds, seconds, next)) {
        part(fault.where).sensor.scale_capacitor(now, fault.factor);
        fault.seconds = std::numeric_limits<double>::infinity();
      }
    }
    bool pulled = false;
    for (const PulledCable& cable : plan_.cable) {
      if (!is_due(cable.from_seconds, seconds, next)) continue;
      pulled = pulled || !is_due(cable.from_seconds + cable.for_seconds, seconds, next);
    }
    line_.connect(!pulled);
    next_wake_ = std::isfinite(next) ? std::max(rate_.clocks(next), now + 1) : sim::never;
  }

 private:
  static bool is_due(double planned, double seconds, double& next) {
    if (planned <= seconds) return true;
    next = std::min(next, planned);
    return false;
  }
  HeatedPart& part(Heated where) {
    if (where == Heated::bed) return printer_.bed_;
    return where == Heated::hotend ? printer_.hotend_ : *printer_.second_hotend_;
  }

  FaultPlan plan_;
  sim::ClockRate rate_;
  Printer& printer_;
  devices::SerialLine& line_;
};

}  // namespace machine
