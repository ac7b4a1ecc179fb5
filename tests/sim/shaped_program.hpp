// SPDX-License-Identifier: Apache-2.0
// Lines as slicers write them, as text and as ways, and random programs of them.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "shaped_printer.hpp"

namespace tests {

class ProgramWriter {
 public:
  explicit ProgramWriter(const PlanLimits& limits = {}) : limits_(limits) {}

  const std::vector<Command>& commands() const { return commands_; }
  Axes place_mm() const;
  void feed(double mm_s) { feed_mm_s_ = mm_s; }
  // By so much in mm; what is 0 is not written. `always`: an axis that is.
  void line(double x, double y, double z = 0, double e = 0, int always = -1);
  // About a centre that is off by this, by an angle; a full turn ends where it begins.
  void arc(double i, double j, double angle, double z = 0, double e = 0);
  void retract_by_code();
  void recover_by_code();
  void dwell(double seconds);
  void rest() { commands_.push_back({.text = "M400", .waits = true}); }
  void relative(bool relative);  // all axes, or E alone
  void relative_extruder(bool relative);
  void inches(bool inches);
  void name_place(std::size_t axis, double mm);
  void percent(int percent);
  void text(const std::string& text) { commands_.push_back({.text = text}); }
  void shape(const std::string& text, const ShapingChoice& choice) {
    commands_.push_back({.text = text, .waits = true, .shaping = choice});
  }

 private:
  using Units = std::int64_t;  // 10 nm
  Axes steps() const;
  std::string word(char letter, std::size_t axis, double by_mm);
  std::string length_word(char letter, Units value) const;
  Units rounded(double mm) const;
  void add_feed(std::string& text);
  double speed() const { return feed_mm_s_ * percent_ / 100; }

  PlanLimits limits_;
  std::array<Units, 4> place_{}, named_{};  // of the machine; as the file calls it
  bool relative_{}, relative_extruder_{}, inches_{}, retracted_{};
  double feed_mm_s_ = 50, written_feed_ = 0;
  int percent_ = 100;
  std::vector<Command> commands_;
};

// The kinds of lines that a slicer makes, one after the other, and all the modes.
class RandomProgram {
 public:
  // `calm`: shaped throughout, at one speed, without what faults hide behind.
  RandomProgram(std::uint32_t seed, double clock_hz, bool calm = false);

  const ShapingChoice& given() const { return given_; }
  const std::vector<Command>& commands() const { return writer_.commands(); }
  const PlanLimits& limits() const { return limits_; }
  std::size_t buffered() const { return buffered_; }

 private:
  double between(double low, double high) {
    return std::uniform_real_distribution(low, high)(random_);
  }
  int pick(int count) { return std::uniform_int_distribution(0, count - 1)(random_); }
  ShapingChoice shaping();
  ShaperChoice shaper();
  void add();
  void add_calm();
  void add_curve();
  void add_infill();
  void add_retraction();
  void add_circle();
  void change_mode();
  void change_shaping();
  void go(double x, double y, bool prints);

  std::mt19937 random_;
  bool may_retract_by_code_;  // the judge does not know how fast
  double most_hertz_;
  PlanLimits limits_;
  ShapingChoice given_, now_;
  std::size_t buffered_;
  ProgramWriter writer_;
};

}  // namespace tests
