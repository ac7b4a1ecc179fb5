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
#include "sim/report/femtometers.hpp"
#include "sim/report/file_coordinates.hpp"
#include "sim/report/gcode_words.hpp"

namespace report {

// Exact machine positions, zero at the end stops: offsets of G92 are taken out.
using Point = std::array<Femtometers, 4>;  // x y z e

struct Move {
  Point from{};
  Point to{};
  std::optional<ArcShape> arc;
  std::optional<Point> over{};  // two straight lines with this place between them: G27
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

// What the file's motion depends on: the machine's description.
struct MachineFacts {
  Retraction retraction;
  std::array<Femtometers, 3> travel{};  // for G27 and M428
  HomePlace home{};
};

// Understands G0 to G3, G10 G11, G17 to G21, G27, G28, G53 to G61, G90 to G92, M82 M83 M92 M200
// M206 to M208 M221 M290 M400 M410 M428 and M104 M109 M140 M149 M190; all else asks no motion.
class GcodePath {
 public:
  explicit GcodePath(const MachineFacts& machine = {})
      : facts_(machine), retraction_(machine.retraction) {}

  Request read(std::string_view command);
  const Point& position() const { return machine_; }

  // The machine stands here without having been sent there: after M410, or where the chip said that
  // it prevents an extrusion. What the file calls the place stays as it is.
  void stand_at(std::size_t axis, Femtometers place) { machine_[axis] = place; }

 private:
  void read_g(const GcodeWords& words, Request& request);
  bool read_coordinates(const GcodeWords& words);
  bool read_offsets(const GcodeWords& words);
  void read_m(const GcodeWords& words, Request& request);
  double celsius(double temperature) const;
  std::optional<Femtometers> length(const GcodeWords& words, char letter) const;
  Request move(const GcodeWords& words, bool machines = false);
  // To a place of the machine; what the file calls it changes by as much.
  Request lead_to(const Point& place);
  Request park(const GcodeWords& words);
  void save(const GcodeWords& words);
  Request restore(const GcodeWords& words);
  Femtometers filament_of(Femtometers requested) const;
  void rename_axes(const FileCoordinates& changed);
  std::optional<ArcShape> arc_of(const GcodeWords& words, const Move& move) const;
  Request home(const GcodeWords& words);
  Request retract();
  Request recover();
  void set_position(const GcodeWords& words);

  Point machine_{};
  Point logical_{};  // what the file calls it
  FileCoordinates coordinates_;
  std::array<std::optional<Point>, 2> saved_;  // of G60, as the file calls it without shifts
  Femtometers babystep_{};  // of M290, still to be made
  double filament_mm_{};  // the diameter of M200
  bool volumetric_ = false;
  MachineFacts facts_;
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
