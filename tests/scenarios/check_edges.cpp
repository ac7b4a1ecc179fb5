// SPDX-License-Identifier: Apache-2.0
// check_edges: do the step edges of a print make exactly what its G-code requests?
//
// Replays the edges and walks the G-code along with them: every point of the file is reached to
// the step, in order, and between two points the path stays within a step of the straight line.
// Homing (G28) may move freely, but must end with its axes at 0. Also looks at the
// rising edges' spacing.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <CLI/CLI.hpp>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/scenarios/requested_moves.hpp"

namespace {

using scenarios::axes;
using scenarios::RequestedMove;
using Position = std::array<std::int64_t, axes>;

// All edges of one clock.
struct Instant {
  std::int64_t cycle{};
  Position step{};  // -1, 0, 1 per axis
};

struct Edges {
  std::vector<Instant> instants;
  Position start{};
  std::array<std::int64_t, axes> shortest_interval{};
};

Edges read_edges(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line) || line != "cycle,axis,direction,position") {
    throw std::runtime_error(path + ": not an edges file");
  }
  Edges edges;
  edges.shortest_interval.fill(INT64_MAX);
  std::array<std::int64_t, axes> last_cycle{};
  std::array<bool, axes> seen{};
  Position position{};
  while (std::getline(file, line)) {
    std::int64_t cycle = 0;
    char letter = 0;
    std::int64_t direction = 0;
    std::int64_t place = 0;
    if (std::sscanf(line.c_str(), "%ld,%c,%ld,%ld", &cycle, &letter, &direction, &place) != 4) {
      throw std::runtime_error(path + ": bad row: " + line);
    }
    const std::size_t axis = std::string_view("xyze").find(letter);
    if (axis >= axes) throw std::runtime_error(path + ": unknown axis: " + line);
    if (!seen[axis]) {
      edges.start[axis] = position[axis] = place - direction;
      seen[axis] = true;
    } else {
      edges.shortest_interval[axis] =
          std::min(edges.shortest_interval[axis], cycle - last_cycle[axis]);
    }
    if (position[axis] + direction != place) {
      throw std::runtime_error(path + ": a step was lost: " + line);
    }
    position[axis] = place;
    last_cycle[axis] = cycle;
    if (edges.instants.empty() || edges.instants.back().cycle != cycle) {
      if (!edges.instants.empty() && edges.instants.back().cycle > cycle) {
        throw std::runtime_error(path + ": not in order of time: " + line);
      }
      edges.instants.push_back({cycle, {}});
    }
    edges.instants.back().step[axis] += direction;
  }
  return edges;
}

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

class Walk {
 public:
  Walk(const Edges& edges, const std::vector<RequestedMove>& moves) : edges_(edges), moves_(moves) {
    position_ = edges.start;
    // Before homing only the frame knows where X, Y and Z are; E counts from where it is.
    position_[3] = 0;
  }

  bool run() {
    RequestedMove from;
    for (std::size_t index = 0; index < moves_.size(); ++index) {
      const RequestedMove& move = moves_[index];
      if (!(move.homing ? home(index) : follow(from, move))) return false;
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
        if (position_[axis] < low || position_[axis] > high) return fail(move, "leaves the line");
      }
      const double distance = distance_xy(position_, from, move);
      if (trying_ && distance > 2) {
        return false;  // still homing
      }
      if (distance > worst_distance_) {
        worst_distance_ = distance;
        worst_line_ = move.line;
      }
    }
    return true;
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
  std::int64_t shortest = 0;
  app.add_option("gcode", gcode)->required();
  app.add_option("edges", edges_file)->required();
  app.add_option("--steps-per-mm", steps_per_mm, "x y z e");
  app.add_option("--tolerance", tolerance, "largest distance from the line on X and Y, in steps");
  app.add_option("--shortest-interval", shortest, "fewest clocks between two edges of an axis");
  CLI11_PARSE(app, argument_count, arguments);
  try {
    const auto moves = scenarios::requested_moves(gcode, steps_per_mm);
    const Edges edges = read_edges(edges_file);
    Walk walk(edges, moves);
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
