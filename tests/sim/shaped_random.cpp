// SPDX-License-Identifier: Apache-2.0
// Random programs: what slicers make, in random order.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shaped_program.hpp"

namespace tests {

namespace {

constexpr double filament_per_mm = 0.04;

}  // namespace

RandomProgram::RandomProgram(std::uint32_t seed, double clock_hz, bool calm)
    : random_(seed), may_retract_by_code_(!calm), most_hertz_(clock_hz > 1e7 ? 80 : 40) {
  limits_.acceleration_mm_s2 =
      std::array{800., 2000., 6000., 30000.}[static_cast<std::size_t>(pick(4))];
  const double jerk = std::array{2., 10., 25., 200.}[static_cast<std::size_t>(pick(4))];
  limits_.jerk_mm_s = {jerk, jerk, jerk / 10, jerk / 2};
  do {
    given_ = now_ = shaping();
  } while (calm && !given_.any());
  buffered_ = static_cast<std::size_t>(1 + pick(24));
  writer_ = ProgramWriter(limits_);
  if (pick(2) == 0) writer_.relative_extruder(true);
  writer_.feed(60);
  writer_.line(between(20, 60), between(20, 60), 0.2);
  const int lines = 5 + pick(12);
  writer_.feed(calm ? between(15, 60) : 60);
  for (int i = 0; i < lines; ++i) calm ? add_calm() : add();
  writer_.recover_by_code();
  if (pick(2) == 0) writer_.rest();
}

ShaperChoice RandomProgram::shaper() {
  constexpr std::array kinds{"none", "zv", "zvd", "mzv", "ei", "2hump_ei"};
  ShaperChoice choice{kinds[static_cast<std::size_t>(pick(6))]};
  if (choice.kind == "none") return choice;
  choice.hertz = std::round(between(choice.kind == "2hump_ei" ? 25 : 15, most_hertz_) * 10) / 10;
  choice.damping = std::round(between(0, 0.3) * 100) / 100;
  return choice;
}

ShapingChoice RandomProgram::shaping() {
  ShapingChoice choice;
  const int kind = pick(4);
  if (kind != 0) choice.x = choice.y = shaper();
  if (kind > 1) choice.y = shaper();
  if (pick(2) == 0) choice.advance_s = std::round(between(0.005, 0.15) * 1000) / 1000;
  return choice;
}

// Stays on a bed of 20 to 180 mm.
void RandomProgram::go(double x, double y, bool prints) {
  const Axes here = writer_.place_mm();
  if (here[0] + x < 20 || here[0] + x > 180) x = -x;
  if (here[1] + y < 20 || here[1] + y > 180) y = -y;
  writer_.line(x, y, 0, prints ? filament_per_mm * std::hypot(x, y) : 0);
}

void RandomProgram::add() {
  if (pick(3) == 0) writer_.feed(std::round(between(5, 150) * 10) / 10);
  const double angle = between(0, 2 * std::numbers::pi);
  switch (pick(12)) {
    case 0:
    case 1:
      return go(between(5, 50) * std::cos(angle), between(5, 50) * std::sin(angle), true);
    case 2:
      return add_curve();
    case 3:
      return add_infill();
    case 4: {  // there and back
      const double x = between(0.02, 15) * std::cos(angle), y = pick(2) * between(0.02, 15);
      const int times = 1 + pick(6);
      for (int i = 0; i < times; ++i) {
        writer_.line(x, y, 0, 0.2);
        writer_.line(-x, -y, 0, pick(2) * 0.2);
      }
      return;
    }
    case 5:
      return add_circle();
    case 6:
      return add_retraction();
    case 7:
      writer_.line(0, 0, 0.4);
      go(between(-20, 20), between(-20, 20), false);
      return writer_.line(0, 0, -0.4);
    case 8:
      return writer_.dwell(std::round(between(0, 120)) / 1000);
    case 9:
      return writer_.line(0, 0, 0, 0, pick(4));
    case 10:
      return change_mode();
    default:
      return pick(2) == 0 ? writer_.rest() : change_shaping();
  }
}

void RandomProgram::add_calm() {
  const double angle = between(0, 2 * std::numbers::pi);
  switch (pick(7)) {
    case 0:
      return add_circle();
    case 1:
      return add_retraction();
    case 2:
      writer_.line(0, 0, 0.4);
      go(between(-20, 20), between(-20, 20), false);
      return writer_.line(0, 0, -0.4);
    case 3:
      return pick(2) == 0 ? writer_.rest() : writer_.dwell(0.05);
    default:
      return go(between(0.5, 40) * std::cos(angle), between(0.5, 40) * std::sin(angle), true);
  }
}

void RandomProgram::add_curve() {
  double angle = between(0, 2 * std::numbers::pi);
  const double turn = between(-0.1, 0.1),
               length = std::array{0.01, 0.05, 0.2}[static_cast<std::size_t>(pick(3))];
  const int count = 10 + pick(80);
  for (int i = 0; i < count; ++i, angle += turn) {
    go(length * std::cos(angle), length * std::sin(angle), true);
  }
}

void RandomProgram::add_infill() {
  const double angle = between(0, 2 * std::numbers::pi), length = between(0.02, 8),
               step = between(0.01, 0.6);
  const double c = std::cos(angle), s = std::sin(angle);
  const int count = 2 + pick(20);
  for (int i = 0; i < count; ++i) {
    const double way = i % 2 == 0 ? length : -length;
    writer_.line(way * c, way * s, 0, filament_per_mm * length);
    if (pick(4) != 0) writer_.line(-step * s, step * c, 0, filament_per_mm * step);
  }
}

void RandomProgram::add_circle() {
  const double radius = std::array{0.1, 0.5, 3., 12.}[static_cast<std::size_t>(pick(4))];
  const double towards = between(0, 2 * std::numbers::pi);
  const double angle = pick(2) == 0 ? 6.29 : between(0.1, 6.2);
  const bool prints = pick(3) != 0;
  writer_.arc(radius * std::cos(towards), radius * std::sin(towards), pick(2) == 0 ? angle : -angle,
              pick(4) == 0 ? 0.2 : 0, prints ? filament_per_mm * radius * angle : 0);
}

void RandomProgram::add_retraction() {
  const bool by_code = may_retract_by_code_ && pick(2) == 0;
  if (by_code) {
    writer_.retract_by_code();
  } else {
    writer_.line(0, 0, 0, -1.5);
  }
  go(between(-30, 30), between(-30, 30), false);
  if (by_code) {
    if (pick(4) != 0) writer_.recover_by_code();
  } else {
    writer_.line(0, 0, 0, 1.5);
  }
}

void RandomProgram::change_mode() {
  const int kind = pick(6);
  if (kind == 0) writer_.relative(pick(2) == 0);
  if (kind == 1) writer_.inches(pick(2) == 0);
  if (kind == 2) writer_.name_place(3, pick(2) * 5.0);
  if (kind == 3) writer_.name_place(static_cast<std::size_t>(pick(2)), between(-50, 50));
  if (kind == 5) writer_.relative_extruder(pick(2) == 0);
  if (kind == 4) writer_.percent(50 + pick(120));
}

void RandomProgram::change_shaping() {
  const int kind = pick(6);
  if (kind == 0) return writer_.shape("M502", now_ = given_);
  if (kind < 3) {
    now_.advance_s = pick(3) == 0 ? 0 : std::round(between(0.005, 0.1) * 1000) / 1000;
    return writer_.shape(kind == 1 ? fmt::format("M900 K{:.3f}", now_.advance_s)
                                   : fmt::format("M572 S{:.3f}", now_.advance_s),
                         now_);
  }
  const ShaperChoice next = shaper();
  if (kind == 3 || kind == 5) now_.x = next;
  if (kind == 4 || kind == 5) now_.y = next;
  if (next.kind == "none") {
    return writer_.shape(fmt::format("M593{} F0", kind == 3 ? " X" : kind == 4 ? " Y" : ""), now_);
  }
  writer_.shape(fmt::format("M593{} F{:.1f} D{:.2f} P\"{}\"",
                            kind == 3   ? " X"
                            : kind == 4 ? " Y"
                                        : "",
                            next.hertz, next.damping, next.kind),
                now_);
}

}  // namespace tests
