// SPDX-License-Identifier: Apache-2.0
// The motion that a G-code file requests, by an interpreter independent of the firmware, which
// it judges.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "sim/report/arc_shape.hpp"
#include "sim/report/gcode_words.hpp"

namespace report {

// A billionth of a millimetre, of an inch, and percents of both are whole numbers of femtometres.
__extension__ using Femtometers = __int128;
inline constexpr Femtometers femtometers_per_mm = 1'000'000'000'000;

// Exact machine positions, zero at the end stops: offsets of G92 are taken out.
using Point = std::array<Femtometers, 4>;  // x y z e

constexpr double millimeters(Femtometers length) {
  return static_cast<double>(length) / static_cast<double>(femtometers_per_mm);
}

struct Move {
  Point from{};
  Point to{};
  std::optional<ArcShape> arc;
};
struct Homing {
  std::array<bool, 3> axes{};
};
struct TemperatureTarget {
  bool bed{};
  double celsius{};
  bool waits{};  // M109, M190
};
struct NewResolution {
  std::array<std::optional<std::int64_t>, 4> steps_per_mm{};  // in billionths
};
struct Rest {};  // M400: everything before it has been made
struct QuickStop {};  // M410: what was under way stays undone
struct NoMotion {};
using Request =
    std::variant<NoMotion, Move, Homing, TemperatureTarget, NewResolution, Rest, QuickStop>;

// What G10 does: M207 S and Z, with M208 S what G11 does. Marlin's defaults, those of a machine
// without [retraction].
struct Retraction {
  Femtometers length = 3 * femtometers_per_mm;
  Femtometers lift{};
  Femtometers extra{};
};

// Where G28 ends: Cartesian machines find their axes one by one, at 0.
struct HomePlace {
  bool of_all_axes{};
  std::array<Femtometers, 3> place{};
};

// Understands G0 to G3, G10 G11, G17 to G21, G28, G90 to G92, M82 M83 M92 M207 M208 M221 M400 M410
// and M104 M109 M140 M149 M190; all else asks no motion.
class GcodePath {
 public:
  explicit GcodePath(const Retraction& retraction = {}, const HomePlace& home = {})
      : home_(home), machines_retraction_(retraction), retraction_(retraction) {}

  Request read(std::string_view command);
  const Point& position() const { return machine_; }

  // The machine stands here without having been sent there: after M410, or where the chip said that
  // it prevents an extrusion. What the file calls the place stays as it is.
  void stand_at(std::size_t axis, Femtometers place) { machine_[axis] = place; }

 private:
  void read_g(const GcodeWords& words, Request& request);
  void read_m(const GcodeWords& words, Request& request);
  double celsius(double temperature) const;
  std::optional<Femtometers> length(const GcodeWords& words, char letter) const;
  Request move(const GcodeWords& words);
  std::optional<ArcShape> arc_of(const GcodeWords& words, const Move& move) const;
  Request home(const GcodeWords& words);
  Request retract();
  Request recover();
  void set_position(const GcodeWords& words);

  HomePlace home_;
  Point machine_{};
  Point logical_{};  // what the file calls it
  Retraction machines_retraction_;
  Retraction retraction_;
  std::optional<Retraction> retracted_;  // what G10 has done
  Femtometers above_file_{};  // the machine's Z above that of the file then
  bool has_jumped_ = false;  // since then, by a stop or homing
  std::int64_t flow_percent_ = 100;
  std::size_t plane_ = 0;  // G17 XY, G18 ZX, G19 YZ
  bool inches_ = false;
  char temperature_unit_ = 'C';  // or F or K
  bool absolute_ = true;
  bool extruder_absolute_ = true;
};

}  // namespace report
