// SPDX-License-Identifier: Apache-2.0
// Keeps the step generator's queue filled, runs homing, and synchronises planner and hardware after
// every stop.
#pragma once

#include <array>
#include <cstdint>
#include <expected>
#include <optional>

#include "application/machine_description.hpp"
#include "application/pace.hpp"
#include "application/task_timing.hpp"
#include "application/tick_clock.hpp"
#include "drivers/end_stops.hpp"
#include "drivers/step_generator.hpp"
#include "motion/homing.hpp"
#include "motion/planner.hpp"
#include "motion/shaping.hpp"
#include "units/axes.hpp"
#include "units/if_two_tools.hpp"

namespace application {

class MotionTask {
 public:
  MotionTask(const MachineDescription& machine, units::Hertz clock,
             drivers::StepGenerator& step_generator, drivers::EndStops& end_stops,
             const OptionalParts& parts = {});

  // Sets up guards, rate floor, end stops and shaping. Once, at rest. False where the machine's
  // shaping is out of range, and thus off.
  bool start();
  // Every pass of the loop, first: the sign of life, and the time of motion.
  void update(const Now& now);
  // Stops, chords, homing. True if there was one of these to be done.
  [[gnu::noinline]] bool plan(const Now& now);
  // Hands over a line, or what of it the step generator has room for, if that is due. True if there
  // may be more.
  bool refill(units::Microseconds now);
  // How long motion goes on by itself at least, where lines wait that must go on before it ends:
  // microseconds at refill(), no_haste or less.
  static constexpr std::int32_t no_haste = 1 << 30;
  // No task needs more; as clocks it fits into 31 bits.
  static constexpr std::int32_t most_in_hand = 1'000'000;
  std::int32_t time_in_hand() const;
  // The lines of a start are collected before it, while all else waits.
  bool collecting() const {
    return (collecting_ || start_is_due()) && !stopping_ && !step_generator_.stopped();
  }
  // The longest time from one look to the next at whether lines must be handed over.
  units::Microseconds longest_pass() const { return planner_.timing().longest_pass; }
  // refill() had no more room for segments: these may be short, so no more than the longest pass
  // needs may be in hand.
  bool queue_full() const { return queue_full_; }

  // Inlined as levels() is.
  [[gnu::always_inline]] bool has_room() const { return planner_.has_room() && line_is_whole(); }
  std::size_t room() const { return motion::Planner::capacity - planner_.lines(); }
  // Switches the motors on. `target` in machine coordinates. Where motors do not follow a line by
  // themselves, the planner gets the first of its chords now, and one more in each pass.
  std::expected<void, motion::Fault> append(const motion::LineMove& move);
  // What has been appended starts without waiting for more.
  [[gnu::always_inline]] void flush() {
    if (line_is_whole()) {
      planner_.flush();
    } else if (levelled()) {
      levelling_->line.flush();
    } else {
      chords_.flush();
    }
  }
  // Input shaping and linear advance are fitted.
  // Inlined for certain, so that link-time optimisation drops what depends on it.
  [[gnu::always_inline]] bool shapes() const { return shaping_in_image && shaping_ != nullptr; }
  // Only where they are.
  const motion::ShapingSettings& shaping() const { return shaping_->settings(); }
  // Only at rest. False, and nothing done, where a shaper's frequency is out of range.
  bool set_shaping(const motion::ShapingSettings& settings);
  // What the machine description says. As above.
  bool restore_shaping();

  // Motors take up the play of their drives.
  [[gnu::always_inline]] bool takes_up_backlash() const { return planner_.takes_up_backlash(); }
  // Only where they do.
  const motion::Backlash& backlash() const { return planner_.backlash(); }
  // Only at rest: the axes stay where they are.
  void set_backlash(const motion::BacklashSettings& settings);

  // A probe and a mesh are fitted.
  [[gnu::always_inline]] bool levels() const { return levelling_in_image && levelling_ != nullptr; }
  // Lines follow the mesh.
  [[gnu::always_inline]] bool levelled() const { return levels() && levelling_->active; }
  // Only where they are fitted.
  const motion::Levelling& levelling() const { return *levelling_; }
  const motion::LevellingSettings& fitted_levelling() const { return *machine_.levelling; }
  // Only at rest: makes the change while lines do not follow the mesh, and whether they do so after
  // it. The nozzle stays where it is. False where they cannot: the mesh has not all of its points,
  // or does not fade slowly.
  template <class Change>
  bool change_levelling(bool follow, const Change& change) {
    stop_levelling();
    change(*levelling_);
    return !follow || begin_levelling();
  }
  // What the machine description says, and no mesh.
  void restore_levelling();
  // Only at rest and homed, lines do not follow the mesh: the height of the bed under the probe.
  void start_probing(units::Nanometers x, units::Nanometers y);
  bool probe_triggered() const { return (end_stops() & probe_input()) != 0; }
  [[gnu::always_inline]] bool probing() const { return levels() && levelling_->probing.active(); }

  // Planner empty, step generator idle, no stop, homing or probing under way.
  bool at_rest() const;

  // Only at rest. After that homing() is true until it ends, well or with a fault.
  void start_homing(units::AxisSet axes);
  bool homing() const { return homing_.active(); }
  std::optional<motion::Fault> homing_fault() const { return homing_fault_; }
  units::Axis homing_axis() const { return homing_axis_; }
  units::AxisSet homed() const { return homed_; }
  // Homed, and since then nothing can have moved it but its own steps.
  units::AxisSet located() const { return located_; }

  // M410: no step from now on. Positions stay correct; what was planned is discarded.
  void quick_stop();
  // Until M999 or a reset: as above, and motors off.
  void shut_down();
  bool stopping() const { return stopping_; }
  // The emergency stop input has ended motion.
  bool emergency_input() const { return emergency_input_; }
  // Motion has been stopped because update() was not called in time.
  bool watchdog_stop() const { return watchdog_stop_; }

  // Whether what is planned already can be made slower; otherwise stretches have no effect.
  bool stretches_time() const { return step_generator_.stretches_time(); }
  Stretch stretch() const { return pace_.stretch(); }
  // For what has been appended so far, from this moment on, and for the lines appended from now on:
  // as soon as the first of them is handed over, 40 ms or less before it begins.
  void set_stretch(Stretch now, Stretch behind);
  // The pause in the middle of a move.
  void hold(bool held) { pace_.hold(held); }

  void enable_motors(units::AxisSet axes, bool enabled);
  // Which extruder E is: its filament is where it was when it was E last, and no coordinate
  // changes but the machine's E. The motor of the other one is off. Only at rest.
  void select_extruder(std::size_t extruder);
  std::size_t extruder() const { return units::most_tools == 1 ? 0 : extruder_[0]; }
  std::uint8_t end_stops() const { return end_stops_.triggered(); }

  const motion::kinematics::Chosen& kinematics() const { return planner_.kinematics(); }
  const motion::Limits& limits() const { return planner_.limits(); }
  void set_limits(const motion::Limits& limits);
  // The same with other steps per millimetre, only at rest: the position in millimetres is kept.
  void set_steps_per_meter(const motion::Limits& limits);
  // M666: what homing finds from now on. Only at rest.
  void set_kinematics(const motion::kinematics::Chosen& kinematics) {
    planner_.set_kinematics(kinematics);
  }
  // M665: the same motors move the tool otherwise, and where it is is not known any more: until it
  // is homed no line is accepted. Only at rest.
  void change_geometry(const motion::kinematics::Chosen& kinematics, const motion::Limits& limits);

  // Machine coordinates of the end of the last planned move, and the steps made so far, without
  // those for backlash: after a stop by its length at most off the axis, until that moves.
  [[gnu::always_inline]] const units::PerAxis<units::Position>& position() const {
    if (levelled()) return levelling_->place;
    return chords_.done() ? planner_.position() : chords_.target();
  }
  units::PerAxis<units::Steps> steps();
  // Counts the times that position() has jumped: at homing, quick stops and changes of levelling.
  std::uint32_t position_jumps() const { return position_jumps_; }

 private:
  bool hand_over_line();
  // Motion goes on by other rules where it is shaped.
  bool is_shaped() const { return shapes() && shaping_->active(); }
  bool start_is_due() const { return !is_shaped() && planner_.start_is_due(pace_.time()); }
  void begin_collecting();
  // All of it is with the step generator.
  [[gnu::always_inline]] bool plan_is_done() const {
    return planner_.empty() && (!shapes() || shaping_->at_rest());
  }
  // The last move has no chords left.
  [[gnu::always_inline]] bool line_is_whole() const {
    return chords_.done() && (!levels() || levelling_->line.done());
  }
  // Of its counter from the place of its axis.
  [[gnu::always_inline]] std::int32_t lead(std::size_t motor) const {
    return takes_up_backlash() ? backlash().lead(motor) : 0;
  }
  motion::Shaping::Output next_segment();
  bool settle_stop(units::Milliseconds now);
  void lead_homing(units::Milliseconds now);
  void carry_out(const motion::HomingRequest& request);
  void begin_line();
  void note_lost(units::Axis axis);
  std::expected<void, motion::Fault> append_chords(motion::LineMove move);
  std::expected<void, motion::Fault> append_line(const motion::LineMove& move);
  std::expected<void, motion::Fault> limit_to_mechanism(motion::LineMove& move) const;
  void go_on_with_chords();
  std::expected<void, motion::Fault> append_levelled(motion::LineMove move);
  bool reaches_levelled(const motion::LineMove& move, std::uint32_t chords);
  void go_on_levelled();
  void stop_levelling();
  bool begin_levelling();
  void find_levelled_place();
  void lead_probing();
  std::uint8_t probe_input() const;
  motion::LineMove homing_move(const motion::HomingMove& request) const;
  void pass_end_stop(const motion::HomingRequest& request);
  void finish_homing_of_motors();
  units::Nanometers distance_to_end_stop(units::Axis axis) const;
  void set_position(const units::PerAxis<units::Position>& positions);

  const MachineDescription& machine_;
  units::Hertz clock_;
  drivers::StepGenerator& step_generator_;
  drivers::EndStops& end_stops_;
  motion::Planner planner_;
  motion::Shaping* shaping_;
  motion::Levelling* levelling_;
  [[no_unique_address]] motion::kinematics::Chosen::Chords chords_;  // of the last line
  motion::Homing homing_;
  Pace pace_;
  std::optional<Stretch> stretch_behind_;  // of the lines after the next `lines_before_`
  std::size_t lines_before_{};
  std::optional<motion::Fault> homing_fault_;
  units::Axis homing_axis_{};
  units::AxisSet homed_;
  units::AxisSet located_;
  units::AxisSet motors_on_;
  std::uint32_t position_jumps_{};
  bool stopped_by_end_stop_{};
  units::Milliseconds rings_until_{};  // the motor that an end stop has stopped
  bool stopping_{};
  bool queue_full_{};
  units::Microseconds queue_lasts_until_{};  // at least, where it is full
  bool collecting_{};
  bool emergency_input_{};
  bool watchdog_stop_{};
  [[no_unique_address]] units::IfTwoTools<std::uint8_t> extruder_{};
  // Of the extruders, when they were E last.
  [[no_unique_address]] units::IfTwoTools<std::array<units::Position, units::most_tools>>
      filament_{};
};

}  // namespace application
