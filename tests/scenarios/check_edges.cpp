// SPDX-License-Identifier: Apache-2.0
// check_edges: do the step edges of a print make exactly what its G-code requests?
//
// Replays the edges and walks the G-code along with them: every point of the file is reached to
// the step, in order, and between two points the path stays within a step of the straight line, or
// of the circle of G2 and G3, which it goes round in the asked direction.
// Homing (G28) may move as it likes as long as it ends with its axes at home. Also looks at the
// rising edges' spacing. Where motors are not axes (--kinematics), the steps are the motors', and
// of a delta or a SCARA the tool's way in space is looked at.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <CLI/CLI.hpp>
#include <cmath>
#include <complex>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/scenarios/edge_rows.hpp"
#include "tests/scenarios/requested_moves.hpp"

namespace {

using scenarios::axes;
using StepsPerMm = std::array<double, axes>;
using scenarios::Edges;
using scenarios::MachineShape;
using scenarios::Position;
using scenarios::read_edges;
using scenarios::RequestedMove;
using scenarios::Vector;

// Distance in steps of a point from the segment a-b on X and Y, Euclidean.
double distance_xy(const Position& point, const RequestedMove& a, const RequestedMove& b) {
  const double ax = a.exact_steps[0];
  const double ay = a.exact_steps[1];
  const double dx = b.exact_steps[0] - ax;
  const double dy = b.exact_steps[1] - ay;
  const double px = static_cast<double>(point[0]) - ax;
  const double py = static_cast<double>(point[1]) - ay;
  const double square = dx * dx + dy * dy;
  const double along = square > 0 ? std::clamp((px * dx + py * dy) / square, 0.0, 1.0) : 0.0;
  return std::hypot(px - along * dx, py - along * dy);
}

// Distance in mm of a point from the segment a-b in space.
double distance_in_space(const Vector& point, const Vector& a, const Vector& b) {
  double square = 0, product = 0;
  for (std::size_t i = 0; i < point.size(); ++i) {
    square += (b[i] - a[i]) * (b[i] - a[i]);
    product += (point[i] - a[i]) * (b[i] - a[i]);
  }
  const double along = square > 0 ? std::clamp(product / square, 0.0, 1.0) : 0.0;
  Vector off{};
  for (std::size_t i = 0; i < point.size(); ++i) off[i] = point[i] - a[i] - along * (b[i] - a[i]);
  return std::hypot(off[0], off[1], off[2]);
}

class Walk {
 public:
  Walk(const Edges& edges, const std::vector<RequestedMove>& moves, const StepsPerMm& steps_per_mm,
       const MachineShape& shape)
      : edges_(edges),
        moves_(moves),
        steps_per_mm_(steps_per_mm),
        tool_steps_per_mm_(steps_per_mm),
        shape_(shape) {
    position_ = edges.start;
    // Before homing only the frame knows where X, Y and Z are; E counts from where it is.
    position_[3] = 0;
    for (const std::size_t i : {0UZ, 1UZ}) tool_steps_per_mm_[i] /= shape.tool_way();
  }

  bool run() {
    RequestedMove from;
    for (std::size_t index = 0; index < moves_.size(); ++index) {
      const RequestedMove& move = moves_[index];
      const bool good = move.homing ? home(index)
                        : move.arc  ? follow_arc(from, move)
                                    : follow(from, move);
      if (!good) return false;
      from = move;
    }
    if (next_ != edges_.instants.size()) {
      fmt::print("{} instants of edges are left after the last line\n",
                 edges_.instants.size() - next_);
      return false;
    }
    return true;
  }

  double worst_distance() const { return worst_distance_; }
  int worst_line() const { return worst_line_; }

 private:
  bool follow(const RequestedMove& from, const RequestedMove& move) {
    while (position_ != move.steps) {
      if (next_ == edges_.instants.size()) return fail(move, "the edges end");
      step();
      for (std::size_t axis = 0; axis < axes; ++axis) {
        const auto low = std::min(from.steps[axis], move.steps[axis]);
        const auto high = std::max(from.steps[axis], move.steps[axis]);
        const bool may_turn = !shape_.is_straight() && axis < 3 && !shape_.has_own_motor(axis);
        if (may_turn) continue;
        if (position_[axis] < low || position_[axis] > high) return fail(move, "leaves the line");
      }
      const double distance =
          shape_.is_straight()
              ? distance_xy(position_, from, move)
              : distance_in_space(tool(), from.tool, move.tool) * tool_steps_per_mm_[0];
      if (trying_ && distance > 2 + (shape_.is_straight() ? 0 : 4)) {
        return false;  // still homing
      }
      note_distance(move, distance);
    }
    return true;
  }

  // Around the centre in the asked direction until the whole angle is done, near the circle, with
  // the other axes in step.
  bool follow_arc(const RequestedMove& from, const RequestedMove& move) {
    const scenarios::RequestedArc& arc = *move.arc;
    double swept = 0;
    auto before = from_centre(arc);
    while (position_ != move.steps || std::abs(arc.sweep) - swept > angle_of_steps(arc, 3)) {
      if (next_ == edges_.instants.size()) return fail(move, "the edges end");
      step();
      const auto here = from_centre(arc);
      const double turned = std::arg(here / before);
      swept += arc.sweep < 0 ? -turned : turned;
      before = here;
      const double part = std::clamp(swept / std::abs(arc.sweep), 0.0, 1.0);
      const double radius = arc.start_radius + part * (arc.end_radius - arc.start_radius);
      if (std::abs(arc.sweep) - swept < -angle_of_steps(arc, 3)) return fail(move, "goes too far");
      for (std::size_t axis = 0; axis < axes; ++axis) {
        if (axis == arc.plane[0] || axis == arc.plane[1]) continue;
        if (axis < 3 && !shape_.has_own_motor(axis)) {
          const double height =
              from.tool[axis] + part * (move.tool[axis] - from.tool[axis]) - tool()[axis];
          if (std::abs(height) > 0.1) return fail(move, "another axis is out of step");
          continue;
        }
        const double way = static_cast<double>(move.steps[axis] - from.steps[axis]);
        const double off = static_cast<double>(position_[axis] - from.steps[axis]) - part * way;
        // A step of the plane is this much of the way.
        const double steps = 2 + 2 * std::abs(way) * angle_of_steps(arc, 1) / std::abs(arc.sweep);
        if (std::abs(off) > steps) return fail(move, "another axis is out of step");
      }
      note_distance(move, std::abs(std::abs(here) - radius) * fewest_steps_per_mm(arc));
    }
    return true;
  }

  Vector tool() const {
    Vector motors{};
    for (std::size_t i = 0; i < motors.size(); ++i) {
      motors[i] = static_cast<double>(position_[i]) / steps_per_mm_[i];
    }
    return shape_.tool_of(motors);
  }

  std::complex<double> from_centre(const scenarios::RequestedArc& arc) const {
    const Vector here = tool();
    const auto mm = [&](std::size_t i) { return here[arc.plane[i]] - arc.centre[i]; };
    return {mm(0), mm(1)};
  }
  double fewest_steps_per_mm(const scenarios::RequestedArc& arc) const {
    return std::min(tool_steps_per_mm_[arc.plane[0]], tool_steps_per_mm_[arc.plane[1]]);
  }
  double angle_of_steps(const scenarios::RequestedArc& arc, int steps) const {
    return steps / fewest_steps_per_mm(arc) / arc.start_radius;
  }

  void note_distance(const RequestedMove& move, double steps) {
    if (steps <= worst_distance_) return;
    worst_distance_ = steps;
    worst_line_ = move.line;
  }

  // Homing ends at the first instant with its axes at 0 from which the next move can be followed.
  bool home(std::size_t index) {
    const RequestedMove& move = moves_[index];
    std::size_t following = index + 1;
    while (following < moves_.size() && moves_[following].steps == move.steps) ++following;
    while (true) {
      bool home = true;
      for (std::size_t axis = 0; axis < axes; ++axis) home &= position_[axis] == move.steps[axis];
      if (home && can_follow(move, following)) return true;
      if (next_ == edges_.instants.size()) return fail(move, "homing does not end at 0");
      step();
    }
  }

  bool can_follow(const RequestedMove& from, std::size_t following) {
    if (following == moves_.size()) return next_ == edges_.instants.size();
    if (moves_[following].homing) return true;
    const auto position = position_;
    const auto next = next_;
    const auto distance = worst_distance_;
    trying_ = true;
    const bool good = follow(from, moves_[following]);
    trying_ = false;
    position_ = position;
    next_ = next;
    worst_distance_ = distance;
    return good;
  }

  void step() {
    for (std::size_t axis = 0; axis < axes; ++axis) {
      position_[axis] += edges_.instants[next_].step[axis];
    }
    ++next_;
  }

  bool fail(const RequestedMove& move, const char* what) {
    if (!trying_) {
      fmt::print("line {}: {} at {},{},{},{}; asked for {},{},{},{}\n", move.line, what,
                 position_[0], position_[1], position_[2], position_[3], move.steps[0],
                 move.steps[1], move.steps[2], move.steps[3]);
    }
    return false;
  }

  const Edges& edges_;
  const std::vector<RequestedMove>& moves_;
  StepsPerMm steps_per_mm_;
  StepsPerMm tool_steps_per_mm_;  // of the tool's way
  MachineShape shape_;
  Position position_{};
  std::size_t next_ = 0;
  bool trying_ = false;
  double worst_distance_ = 0;
  int worst_line_ = 0;
};

}  // namespace

int main(int argument_count, char** arguments) {
  CLI::App app{"Checks the step edges of a print against its G-code."};
  std::string gcode;
  std::string edges_file;
  std::array<double, axes> steps_per_mm{80, 80, 2560, 500};
  double tolerance = 1.0;
  scenarios::MachineShape shape;
  std::int64_t shortest = 0;
  app.add_option("gcode", gcode)->required();
  app.add_option("edges", edges_file)->required();
  app.add_option("--steps-per-mm", steps_per_mm, "x y z e");
  app.add_option("--kinematics", shape.kinematics, "cartesian, core_xy, delta or scara")
      ->check(CLI::IsMember({"cartesian", "core_xy", "delta", "scara"}));
  app.add_option("--rod", shape.rod, "of a delta, mm");
  app.add_option("--radius", shape.radius, "of a delta, mm");
  app.add_option("--height", shape.height, "of home, of a delta or a SCARA, mm");
  app.add_option("--arms", shape.arms, "of a SCARA, mm");
  app.add_option("--shoulder", shape.shoulder, "of a SCARA, X and Y, mm");
  app.add_option("--elbow-side", shape.elbow_side, "of a SCARA: 1 left, -1 right");
  app.add_option("--end-stops", shape.end_stops, "of a SCARA's arms, degrees");
  app.add_option("--home", shape.home_place, "of a SCARA, X and Y, mm");
  app.add_option("--tolerance", tolerance, "largest distance from the line on X and Y, in steps");
  app.add_option("--shortest-interval", shortest, "fewest clocks between two edges of an axis");
  CLI11_PARSE(app, argument_count, arguments);
  try {
    const auto moves = scenarios::requested_moves(gcode, steps_per_mm, shape);
    const Edges edges = read_edges(edges_file);
    Walk walk(edges, moves, steps_per_mm, shape);
    const bool reached = walk.run();
    fmt::print("{} moves, {} instants, farthest from the line {:.3f} steps (line {})\n",
               moves.size(), edges.instants.size(), walk.worst_distance(), walk.worst_line());
    bool good = reached && walk.worst_distance() <= tolerance;
    for (std::size_t axis = 0; axis < axes; ++axis) {
      if (edges.shortest_interval[axis] == INT64_MAX) continue;
      fmt::print("{}: shortest interval {} clocks\n", "xyze"[axis], edges.shortest_interval[axis]);
      good &= edges.shortest_interval[axis] >= shortest;
    }
    fmt::print("{}\n", good ? "as asked" : "NOT as asked");
    return good ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
