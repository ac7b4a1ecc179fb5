// SPDX-License-Identifier: Apache-2.0
// What a G-code file asks of the motion, read apart from the firmware so that it can judge it.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <variant>

namespace report {

// Machine positions in mm, zero at the end stops: offsets of G92 are taken out.
using Point = std::array<double, 4>;  // x y z e

struct Move {
  Point from{};
  Point to{};
};
struct Homing {
  std::array<bool, 3> axes{};
};
struct TemperatureTarget {
  bool bed{};
  double celsius{};
  bool waits{};  // M109, M190
};
struct NoMotion {};
using Request = std::variant<NoMotion, Move, Homing, TemperatureTarget>;

// Understands G0 G1 G20 G21 G28 G90 G91 G92 M82 M83 and M104 M109 M140 M190; all else asks no
// motion.
class GcodePath {
 public:
  Request read(std::string_view command);
  const Point& position() const { return position_; }

 private:
  Request move(std::string_view words);
  Request home(std::string_view words);
  void set_position(std::string_view words);

  Point position_{};  // of the machine
  Point offset_{};  // machine position minus what the file calls it
  double unit_mm_ = 1.0;
  bool absolute_ = true;
  bool extruder_absolute_ = true;
};

}  // namespace report
