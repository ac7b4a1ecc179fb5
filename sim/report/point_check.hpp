// SPDX-License-Identifier: Apache-2.0
// Compares the lines of the file with the steps of all axes.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "sim/devices/host_listener.hpp"
#include "sim/devices/step_edge.hpp"
#include "sim/report/drive_play.hpp"
#include "sim/report/findings.hpp"
#include "sim/report/gcode_path.hpp"
#include "sim/report/motor_grid.hpp"
#include "sim/report/step_judges.hpp"
#include "sim/simulation/clock_rate.hpp"

namespace report {

// The end of a G0 to G3 is reached where X, Y, Z and E stand at the same time at the steps that are
// nearest to it, halves away from zero. What a refused line requests is not expected; a prevented
// extrusion is a miss, and the lines after it are judged from where E then stands. Homing and
// probing are free until they are acknowledged. Above a mesh the firmware's whole nanometres may
// round Z to the step next to the nearest, where it is as near to half a step.
//
// Whether a line was refused is known only with its answer, when it may have been executed already:
// what the motors do from its sending on is kept and judged then.
class PointCheck : public devices::StepListener, public devices::HostListener {
 public:
  // `start`: mechanical positions at the beginning, where the G-code is at 0 until it homes.
  PointCheck(const std::array<double, 4>& steps_per_mm, const Steps& start, sim::ClockRate rate,
             const MachineFacts& machine = {},
             std::shared_ptr<const machine::Mechanism> mechanism = machine::cartesian_mechanism());

  void stepped(const devices::StepEdge& edge) override;
  void command_sent(sim::Clock now, std::size_t file_line, std::string_view command) override;
  void command_acknowledged(sim::Clock now, std::size_t file_line, std::string_view command,
                            bool executed) override;
  void reply(sim::Clock now, std::string_view line) override;

  struct Judgement {
    std::uint64_t reached{};
    std::uint64_t missed{};
    std::array<std::uint64_t, motor_count> missed_by_axis{};
    std::vector<MissedPoint> list;  // up to a bound
    Steps unasked_steps{};  // made beyond those between the points
    std::array<bool, motor_count> homed_elsewhere{};  // G28 ended away from the end stop
    std::array<bool, motor_count>
        moved_after_end{};  // where all was made, the axis stands elsewhere
  };
  // Of everything so far; lines that are still under way are neither reached nor missed.
  Judgement judgement() const;
  double max_deviation_mm() const { return judges_.path().max_deviation_mm(); }
  double max_deviation_steps() const { return judges_.path().max_deviation_steps(); }
  std::uint64_t lines_apart() const { return judges_.path().lines_apart(); }
  double max_height_error_mm() const { return judges_.path().max_height_error_mm(); }
  // Of the points reached, those where input shaping or linear advance was on, and how far the tool
  // was off its lines then.
  std::uint64_t shaped_points() const { return judges_.shaped().reached(); }
  double max_shaping_mm() const { return judges_.shaped().max_deviation_mm(); }
  // Of the executed moves, in X, Y and Z, as the G-code requests them.
  double length_mm() const { return length_mm_; }
  bool homed() const { return homed_; }

 private:
  struct SentCommand {
    sim::Clock sent{};
    std::size_t file_line{};
    std::string text;
    bool extrusion_prevented{};
  };

  void carry_out(const SentCommand& command);
  void ask(const Move& move, const SentCommand& command);
  std::optional<Steps> other_target(const Move& move) const;
  void take_up(const NewPlay& play);
  void finish_probing(const Probing& probing, const SentCommand& command);
  void finish_homing(const Homing& homing);
  Steps home_motors(const Homing& homing);
  void change_resolution(const NewResolution& resolution);
  void stop_here();
  void close_state(sim::Clock now);
  void judge_states();
  void judge_states_until(sim::Clock until);
  bool shows_babystep(const MachineState& state);
  void ask_babystep();
  void settle_babystep(const SentCommand& next);
  void add_missed(std::vector<UnreachedPoint> points, Judgement& judgement) const;
  void set_shaping();

  MotorGrid grid_;
  sim::ClockRate rate_;
  GcodePath gcode_;
  std::deque<SentCommand> in_flight_;
  MachineState state_;  // while edges of its clock may still come
  std::deque<MachineState> states_;  // that are not judged yet
  DrivePlay play_;
  NewPlay taken_up_;
  StepJudges judges_;
  Judgement judged_;
  std::optional<SentCommand> babystep_;  // M290 that is made at once or with the next line
  double length_mm_ = 0;
  bool homed_ = false;
};

}  // namespace report
