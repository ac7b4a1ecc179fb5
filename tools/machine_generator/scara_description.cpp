// SPDX-License-Identifier: Apache-2.0
// The arms' directions on the whole bed, in floating point: extreme ones are at its border.
#include "machine_generator/scara_description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace machine_generator {

using namespace motion;
using kinematics::Scara;

namespace {

constexpr std::int64_t per_mm = 1'000'000, per_degree = 1'000'000;
constexpr std::int64_t longest_arm = 500 * per_mm, longest = 1'000 * per_mm;
constexpr double least_cosine = 0.984808;  // of 10 degrees

double mm(units::Nanometers length) { return static_cast<double>(length.count()) / per_mm; }

using Directions = std::array<double, 2>;  // degrees
struct Range {
  Directions least{1e9, 1e9}, most{-1e9, -1e9};
};

class Arms {
 public:
  explicit Arms(const Scara::Parameters& scara) : scara_(scara) {}

  // The distance from the shoulder with arms 10 degrees from folded (-1) or stretched (1), mm.
  double radius(double sign) const {
    const double a = mm(scara_.proximal), b = mm(scara_.distal);
    return std::sqrt(a * a + b * b + sign * 2 * a * b * least_cosine);
  }

  bool reach(double x, double y) const {
    if (x < 0 || x > mm(scara_.width) || y < 0 || y > mm(scara_.depth)) return false;
    const double away = std::hypot(x - mm(scara_.shoulder_x), y - mm(scara_.shoulder_y));
    constexpr double rounding = 1e-6;
    return away >= mm(scara_.inner_radius) - rounding && away <= mm(scara_.outer_radius) + rounding;
  }

  Range on_bed() const {
    Range range;
    const double width = mm(scara_.width), depth = mm(scara_.depth);
    constexpr int points = 4'000;
    for (int i = 0; i <= points; ++i) {
      const double part = static_cast<double>(i) / points;
      for (const double end : {0.0, 1.0}) {
        add(range, part * width, end * depth);
        add(range, end * width, part * depth);
      }
      const double angle = 2 * std::numbers::pi * part;
      for (const units::Nanometers circle : {scara_.inner_radius, scara_.outer_radius}) {
        add(range, mm(scara_.shoulder_x) + mm(circle) * std::cos(angle),
            mm(scara_.shoulder_y) + mm(circle) * std::sin(angle));
      }
    }
    return range;
  }

 private:
  void add(Range& range, double x, double y) const {
    if (!reach(x, y)) return;
    const double dx = x - mm(scara_.shoulder_x), dy = y - mm(scara_.shoulder_y);
    const double away = std::hypot(dx, dy);
    const double a = mm(scara_.proximal), b = mm(scara_.distal);
    const double side = scara_.elbow_left ? 1 : -1;
    const double first = std::acos((away * away + a * a - b * b) / (2 * a * away));
    const double second = std::acos((away * away + b * b - a * a) / (2 * b * away));
    const double towards = std::atan2(dy, dx);
    const Directions directions{towards + side * first, towards - side * second};
    for (std::size_t i = 0; i < directions.size(); ++i) {
      // In the turn that ends 10 degrees beyond the end stop.
      constexpr double turn = 360, beyond = 10;
      const double highest = mm(scara_.end_stop[i]) + beyond;
      const double below =
          std::fmod(highest - directions[i] * 180 / std::numbers::pi + 10 * turn, turn);
      range.least[i] = std::min(range.least[i], highest - below);
      range.most[i] = std::max(range.most[i], highest - below);
    }
  }

  Scara::Parameters scara_;
};

bool elbow_is_left(Reader& table) {
  const std::string side = table.text("elbow");
  if (side != "left" && side != "right") table.fail("elbow", "must be \"left\" or \"right\"");
  return side == "left";
}

Scara::Parameters parameters_of(Reader& table) {
  const auto length = [&](const char* key, std::int64_t most) {
    return units::Nanometers(table.scaled(key, per_mm, 10 * per_mm, most));
  };
  const auto pair = [&](const char* key, std::int64_t least, std::int64_t most) {
    const auto values = table.scaled_list(key, per_mm, least, most, 2);
    return std::array{units::Nanometers(values[0]), units::Nanometers(values[1])};
  };
  const auto shoulder = pair("shoulder_mm", -longest, longest);
  const auto bed = pair("bed_mm", 10 * per_mm, longest);
  const auto home = pair("home_mm", 0, longest);
  Scara::Parameters scara{.proximal = length("proximal_mm", longest_arm),
                          .distal = length("distal_mm", longest_arm),
                          .shoulder_x = shoulder[0],
                          .shoulder_y = shoulder[1],
                          .elbow_left = elbow_is_left(table),
                          .inner_radius = length("inner_radius_mm", longest),
                          .outer_radius = length("outer_radius_mm", longest),
                          .width = bed[0],
                          .depth = bed[1],
                          .height = length("height_mm", longest),
                          .home_x = home[0],
                          .home_y = home[1]};
  const auto end_stops =
      table.scaled_list("end_stop_deg", per_degree, -340 * per_degree, 340 * per_degree, 2);
  for (std::size_t i = 0; i < end_stops.size(); ++i) {
    scara.end_stop[i] = Scara::Millionths(end_stops[i]);
  }
  table.finish();
  return scara;
}

void check_radii(const Reader& table, const Scara::Parameters& scara) {
  const Arms arms(scara);
  if (mm(scara.inner_radius) < arms.radius(-1)) {
    table.fail("inner_radius_mm",
               fmt::format("must be {:.3f} at least: the arms would fold to less than 10 degrees",
                           arms.radius(-1)));
  }
  if (mm(scara.outer_radius) > arms.radius(1)) {
    table.fail(
        "outer_radius_mm",
        fmt::format("must be {:.3f} at most: the arms would stretch to more than 170 degrees",
                    arms.radius(1)));
  }
  if (scara.inner_radius >= scara.outer_radius) {
    table.fail("inner_radius_mm", "must be below outer_radius_mm");
  }
  if (!Arms(scara).reach(mm(scara.home_x), mm(scara.home_y))) {
    table.fail("home_mm", "is out of reach: off the bed, or beyond inner or outer radius");
  }
}

void check_travel(const Reader& table, const Scara::Parameters& scara,
                  const motion::Limits& limits) {
  const Range needed = Arms(scara).on_bed();
  constexpr double reserve = 1;
  for (std::size_t i = 0; i < scara.end_stop.size(); ++i) {
    const double most = mm(scara.end_stop[i]), least = most - mm(limits.axes[i].travel);
    if (needed.least[i] >= least + reserve && needed.most[i] <= most - reserve) continue;
    table.fail(
        "end_stop_deg",
        fmt::format("lets the {} arm turn from {:.1f} to {:.1f} degrees (travel_mm of axes.{}"
                    "), but the bed needs {:.1f} to {:.1f} and a degree of reserve",
                    i == 0 ? "proximal" : "distal", least, most, i == 0 ? 'x' : 'y',
                    needed.least[i], needed.most[i]));
  }
}

}  // namespace

void read_scara(Reader& root, application::MachineDescription& machine) {
  Reader table = root.table("scara");
  const Scara::Parameters scara = parameters_of(table);
  check_radii(table, scara);
  check_travel(table, scara, machine.limits);
  const std::array bounds{scara.width, scara.depth, scara.height};
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    // Bounds are the tool's; what the motors go for their end stops stays in homing_search.
    machine.limits.axes[i].homing->towards_positive = true;
    machine.limits.axes[i].travel = bounds[i];
  }
  machine.kinematics = scara;
}

}  // namespace machine_generator
