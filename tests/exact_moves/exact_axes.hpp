// SPDX-License-Identifier: Apache-2.0
// Where G-code says the axes are, in exact rational arithmetic of the test's own: reads the text of
// each line itself and shares nothing with the firmware.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace exact_moves {

__extension__ using Wide = __int128;

inline constexpr std::size_t axis_count = 4;  // X, Y, Z, E

class ExactAxes {
 public:
  explicit ExactAxes(const std::array<std::int32_t, axis_count>& steps_per_meter)
      : steps_per_meter_(steps_per_meter) {}

  // G0 to G3, G20, G21, G90, G91, G92, M82, M83, M221; other lines move nothing.
  void take(std::string_view line);

  // Rounded to the nearest step, halves away from 0.
  std::array<std::int64_t, axis_count> steps() const;
  // What the host believes, in mm; nearly.
  double logical_mm(std::size_t axis) const;
  bool inches() const { return inches_; }
  std::int64_t flow_percent() const { return flow_percent_; }
  bool relative(std::size_t axis) const { return axis == 3 ? extruder_relative_ : relative_; }

 private:
  std::optional<Wide> length(std::string_view line, char letter) const;
  void move(std::string_view line);

  // Parts: 500 of them are a billionth of a millimetre. A billionth of an inch is 25.4 of those, a
  // hundredth of which (a percent) is 127 parts.
  std::array<std::int32_t, axis_count> steps_per_meter_;
  std::array<Wide, axis_count> machine_{}, logical_{};
  std::int64_t flow_percent_{100};
  bool inches_{}, relative_{}, extruder_relative_{};
};

}  // namespace exact_moves
