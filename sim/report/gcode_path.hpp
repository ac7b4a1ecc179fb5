// SPDX-License-Identifier: Apache-2.0
// The motion that a G-code file requests, by an interpreter independent of the firmware, which
// it judges.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "sim/report/arc_shape.hpp"
#include "sim/report/femtometers.hpp"
#include "sim/report/file_coordinates.hpp"
#include "sim/report/gcode_words.hpp"
#include "sim/report/input_shaper.hpp"
#include "sim/report/levelling.hpp"

namespace report {

// x y z e, and the e of a second extruder, which stands still where there is none.
inline constexpr std::size_t motor_count = 5;

// Exact machine positions, zero at the end stops: offsets of G92 are taken out. x y z are the
// carriage's: where tool 0 is. While lines follow a mesh, Z is without what the mesh adds.
using Point = std::array<Femtometers, motor_count>;

struct Move {
  Point from{};
  Point to{};
  std::optional<ArcShape> arc;
  std::optional<Point> over{};  // two straight lines with this place between them
  std::shared_ptr<const BedMesh> mesh{};  // that it follows
  double speed_mm_s{};  // as F asks, at most; 0: another
  double extruder_mm_s{};  // of E, at most; 0: not known
  Femtometers loose_z{};  // by which Z may be off its way: it may have gone there before

  // Of the nozzle in X, Y and Z at a part of the way, 0 to 1.
  std::array<double, 3> place_mm(double part) const;
  double length_mm() const;
  // Itself, or the two lines over a place between.
  std::vector<Move> ways() const;
};
struct Homing {
  std::array<bool, 3> axes{};
};
// G29 or G30: the nozzle ends here.
struct Probing {
  Point nozzle{};
};
struct TemperatureTarget {
  bool bed{};
  double celsius{};
  bool waits{};  // M109, M190
  std::size_t tool{};  // of a hotend
};
struct NewResolution {
  std::array<std::optional<std::int64_t>, 4> steps_per_mm{};  // in billionths
};
// T: one after the other, each from rest to rest; none where the nozzle stays.
struct ToolMoves {
  std::vector<Move> moves;
};
// M425 and what brings it back: what drives have, as far as it is to be taken up.
struct NewPlay {
  std::array<Femtometers, 3> lengths{};
};
struct Babystep {};  // M290: at rest it is made at once
struct Rest {};  // M400: everything before it has been made
struct QuickStop {};  // M410: what was under way stays undone
struct NoMotion {};
using Request = std::variant<NoMotion, Move, ToolMoves, Homing, Probing, TemperatureTarget,
                             NewResolution, NewPlay, Babystep, Rest, QuickStop>;

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

// A second extruder: where its nozzle is from the first, and what a change of tools does (M217).
struct ToolFacts {
  std::array<Femtometers, 3> offset{};
  Femtometers swap{}, resume{}, prime{}, lift{};
};

// What the firmware takes up of the play of drives.
struct PlayFacts {
  std::array<Femtometers, 3> lengths{};
  double part = 1;
};

// What M701 and M702 move of the filament; M603 changes the first two.
struct FilamentFacts {
  Femtometers load{}, unload{}, purge{};
};

// What the file's motion depends on: the machine's description.
struct MachineFacts {
  Retraction retraction;
  std::array<Femtometers, 3> travel{};  // for G27 and M428
  HomePlace home{};
  std::optional<ToolFacts> second_tool{};
  std::optional<ProbeFacts> probe{};
  std::optional<PlayFacts> play{};
  std::optional<FilamentFacts> filament{};
  std::array<double, 3> steps_per_mm{};  // at which a probe is looked at
  std::optional<ShapingSetting> shaping{};
  double fastest_mm_s = 500;  // without F
  double extruder_mm_s{};  // until M203; 0: not known
};

// Understands G0 to G3, G10 G11, G17 to G21, G27 to G30, G53 to G61, G90 to G92, M82 M83 M92
// M200 M203 M205 to M208 M217 M218 M220 M221 M290 M400 M410 M420 M421 M425 M428 M501 M502 M572 M593
// M603 M701 M702 M851 M900, T and M104 M109 M140 M149 M190; all else asks no motion.
class GcodePath {
 public:
  explicit GcodePath(const MachineFacts& machine = {})
      : facts_(machine),
        given_(machine),
        retraction_(machine.retraction),
        change_(machine.second_tool.value_or(ToolFacts())) {
    if (facts_.probe) levelling_ = Levelling(*facts_.probe);
    shaping_ = facts_.shaping.value_or(ShapingSetting());
    extruder_mm_s_ = facts_.extruder_mm_s;
  }

  Request read(std::string_view command);
  const ShapingSetting& shaping() const { return shaping_; }
  const Point& position() const { return machine_; }
  Point nozzle() const { return above(levelling_.followed(), machine_); }

  // The machine stands here without having been sent there, where the chip said that it prevents an
  // extrusion. What the file calls the place stays as it is.
  void stand_at(std::size_t axis, Femtometers place) { machine_[axis] = place; }
  // After M410 the file calls it as its coordinates say.
  void stop_at(const Point& nozzle);
  Femtometers babystep() const { return babystep_; }
  // What of M290 is still to be made, in a move of its own.
  Move make_babystep();

 private:
  Request read_line(const GcodeWords& words);
  void read_g(const GcodeWords& words, Request& request);
  bool read_coordinates(const GcodeWords& words);
  bool read_offsets(const GcodeWords& words);
  void read_m(const GcodeWords& words, Request& request);
  bool read_levelling(const GcodeWords& words, Request& request);
  void read_speed(const GcodeWords& words);
  void hold_back(Move& move) const;
  void read_shaping(const GcodeWords& words, std::string_view command);
  void relevel(bool follow, const std::function<void(Levelling&)>& change);
  Point uncorrected(Point nozzle) const;
  void set_point(const GcodeWords& words, BedMesh& mesh) const;
  Request probe_bed(const GcodeWords& words);
  Request probe_place(const GcodeWords& words);
  double probe_at(double x, double y);
  NewPlay play() const;
  Request set_play(const GcodeWords& words);
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
  std::size_t tool_of(const GcodeWords& words) const;
  Femtometers offset(std::size_t axis) const { return tool_ == 0 ? 0 : change_.offset[axis]; }
  // Of Point: the motor that E moves.
  std::size_t extruder_motor() const { return 3 + tool_; }
  Request change_tool(const GcodeWords& words);
  Request move_filament(const GcodeWords& words);
  void set_change(const GcodeWords& words);
  void set_offset(const GcodeWords& words);

  Point machine_{};
  Point logical_{};  // what the file calls it
  FileCoordinates coordinates_;
  std::array<std::optional<Point>, 2> saved_;  // of G60, as the file calls it without shifts
  Femtometers babystep_{};  // of M290, still to be made
  std::array<double, 2> filament_mm_{};  // of each tool: the diameter of M200
  bool volumetric_ = false;
  MachineFacts facts_, given_;
  Retraction retraction_;
  // Of each tool: what G10 has done, the machine's Z above that of the file then, and whether it
  // has jumped since then, by a stop or homing.
  std::array<std::optional<Retraction>, 2> retracted_;
  std::array<Femtometers, 2> above_file_{};
  std::array<bool, 2> has_jumped_{};
  std::array<std::int64_t, 2> flow_percent_{100, 100};
  double feed_mm_s_{};  // of F; 0: none yet
  std::array<double, 2> least_mm_s_{};  // of M205 S and T
  double extruder_mm_s_{};  // of M203 E
  double retract_mm_s_{}, recover_mm_s_{};  // of M207 and M208; 0: the machine's, not known
  std::int64_t speed_percent_ = 100, kept_speed_percent_ = 100;
  ShapingSetting shaping_;
  ToolFacts change_;
  std::size_t tool_ = 0;  // in use
  std::array<Femtometers, 2> drawn_{};  // of each: what a change of tools has drawn back
  Levelling levelling_;
  std::array<bool, 3> homed_{};
  std::size_t plane_ = 0;  // G17 XY, G18 ZX, G19 YZ
  bool inches_ = false;
  char temperature_unit_ = 'C';  // or F or K
  bool absolute_ = true;
  bool extruder_absolute_ = true;
};

}  // namespace report
