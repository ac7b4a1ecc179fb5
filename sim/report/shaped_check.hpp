// SPDX-License-Identifier: Apache-2.0
// Compares the lines of the file with the steps where input shaping or linear advance is on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "sim/report/input_shaper.hpp"
#include "sim/report/motor_grid.hpp"
#include "sim/report/step_judge.hpp"

namespace report {

// A shaped axis is where a weighted mean of its planned positions is, so it cuts corners. If the
// planned velocity of an axis stays between v0 and v1 while the shaper's impulses lie within, it is
// at most (v1 - v0) / 2 * (mean absolute deviation of the impulses) off: then, without what both
// have in common, v is between -(v1 - v0) / 2 and (v1 - v0) / 2. The velocities are known from F.
// Linear advance adds up to K times the velocity of E.
//
// So around each line there is a space in which the axes may be together. The printer must go
// through these spaces in the order of the lines, without leaving them and no faster than F; where
// it comes to rest, each axis must be at the end of the last line to the step. `Reach` is how much
// of a line it may have done by now.
class ShapedCheck final : public StepJudge {
 public:
  explicit ShapedCheck(double clock_hz, double fastest_mm_s)
      : clock_hz_(clock_hz), fastest_mm_s_(fastest_mm_s) {}

  // From rest.
  void set_shaping(const ShapingSetting& setting);
  void set_grid(const MotorGrid& grid) override { grid_ = grid; }

  void ask(const Move& move, RequestedLine line, const Steps& target,
           const std::optional<Steps>& other) override;
  void at(const MachineState& state) override;
  void end_freely() override { free_ = true; }
  void settle(bool rests) override;
  void abandon() override;
  void restart(const MachineState& here, const Steps& meant) override;

  // No edge shows when the last motion has left the shaper.
  std::optional<bool> rested_at(sim::Clock time) const override;
  bool nothing_open() const override { return lines_.empty(); }
  const Steps& last_target() const override { return last_target_; }
  bool is_at_last_target(const Steps& position) const override {
    return position == last_target_ || position == last_other_;
  }
  std::uint64_t reached() const override { return reached_; }
  const Steps& unasked_steps() const override { return unasked_; }
  std::vector<UnreachedPoint> take_missed() override;
  // How far the tool was off the lines in X and Y, at most.
  double max_deviation_mm() const { return max_deviation_mm_; }

 private:
  using Motors = std::array<double, motor_count>;  // steps, mechanical, or steps/s
  // Over which linear advance takes the velocity of E.
  static constexpr double advance_window_s = 0.020;
  struct Range {
    double low{}, high{};
    void include(double value);
  };
  struct Piece {
    Motors from{}, to{};
    std::array<std::array<double, 2>, 2> ends_mm{};  // in X and Y
    double seconds{};  // that it takes at least
    std::size_t way{};  // that it is part of
    Motors velocity{};
    double advanced{};  // velocity of E that linear advance takes
    Motors loose{};  // by which it may be off its way besides
    // Of all pieces whose motion may be in the shapers at the same time.
    std::array<Range, motor_count> velocities{};
    double most_advanced{};
    std::array<bool, motor_count> turns{};  // where the others move the other way
    std::optional<Range> reach;  // parts of its way
    std::size_t line{};  // that ends with it
    bool ends_line{};
  };
  // Of a motor along a line.
  struct Course {
    double way{};
    int turns{};
    double last{};
  };
  struct Line {
    std::vector<RequestedLine> texts;  // and those behind it that do not move
    Steps target{};
    bool missed{};
  };

  std::vector<double> parts_of(const Move& move, double length, double speed) const;
  void add_pieces(const Move& move, std::array<Course, motor_count>& courses);
  void add(Piece piece);
  bool takes_no_motion(const Move& move, RequestedLine& line, const Steps& target);
  void note_turns(std::size_t piece, std::size_t motor);
  void drop_oldest_line();
  // The parts of a piece on whose way all axes may be at this position.
  std::optional<Range> feasible(const Piece& piece, const Steps& position) const;
  // What may have been reached after a time in which no axis moved.
  void go_on(const Steps& position, double seconds);
  bool keep_feasible();
  bool may_have_ended() const;
  bool find_again(std::size_t from, std::size_t count);
  void pass(std::size_t count);
  void pass_line(std::size_t line);
  void miss(std::size_t line);
  void note_deviation();
  void count_unasked();
  void forget_lines();

  double clock_hz_{};
  double fastest_mm_s_{};
  MotorGrid grid_;
  double slot_s_{};
  double window_s_{};  // how long what was planned has an effect
  std::array<double, motor_count> deviation_s_{};
  std::array<double, motor_count> extra_turns_{};  // steps, where a way is mixed with one back
  double advance_s_{};
  std::deque<Piece> pieces_;
  std::size_t first_{};  // that may still be under way; those before it are in the shapers
  std::size_t behind_reach_{};  // those from here on have not been reached
  double passed_s_{};  // that those before the first take
  std::size_t ways_{};
  std::size_t searched_{};  // of those open, since the track was lost
  std::deque<Line> lines_;
  std::size_t lines_done_{};  // lines_ begins with this one
  MachineState now_, rest_, end_;
  Motors asked_{};  // since the last rest
  Steps last_target_{};
  std::optional<Steps> last_other_;
  bool lost_{}, free_{}, ended_ = true;
  std::uint64_t reached_{};
  Steps unasked_{};
  std::vector<UnreachedPoint> missed_;
  double max_deviation_mm_{};
};

}  // namespace report
