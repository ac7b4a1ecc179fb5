// SPDX-License-Identifier: Apache-2.0
// The kinematics' parameters as C++.
#include <fmt/format.h>

#include "machine_generator/kinematics_description.hpp"

namespace machine_generator {

using namespace motion;

namespace {

struct Name {
  std::string_view operator()(const kinematics::Cartesian::Parameters&) { return "cartesian"; }
  std::string_view operator()(const kinematics::CoreXy::Parameters&) { return "core_xy"; }
  std::string_view operator()(const kinematics::Delta::Parameters&) { return "delta"; }
};

std::string length(units::Nanometers value) {
  return fmt::format("units::Nanometers{{{}}}", value.count());
}

struct Text {
  std::string operator()(const kinematics::Cartesian::Parameters&) { return {}; }
  std::string operator()(const kinematics::CoreXy::Parameters&) {
    return "motion::kinematics::CoreXy::Parameters{}";
  }
  std::string operator()(const kinematics::Delta::Parameters& delta) {
    std::string towers, offsets;
    for (std::size_t i = 0; i < kinematics::spatial_axes; ++i) {
      towers += fmt::format("{{.x = {}, .y = {}}}, ", length(delta.towers[i].x),
                            length(delta.towers[i].y));
      offsets += length(delta.end_stop_offset[i]) + ", ";
    }
    return fmt::format(
        "motion::kinematics::Delta::Parameters{{\n"
        "      .rod = {}, .radius = {},\n      .height = {}, .printable_radius = {},\n"
        "      .towers = {{{{{}}}}},\n      .end_stop_offset = {{{{{}}}}}}}",
        length(delta.rod), length(delta.radius), length(delta.height),
        length(delta.printable_radius), towers, offsets);
  }
};

}  // namespace

std::string_view kinematics_name(const kinematics::Any::Parameters& parameters) {
  return std::visit(Name(), parameters);
}

std::string kinematics_text(const kinematics::Any::Parameters& parameters) {
  const std::string text = std::visit(Text(), parameters);
  return text.empty() ? text : fmt::format("  .kinematics = {},\n", text);
}

}  // namespace machine_generator
