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
  std::string_view operator()(const kinematics::Scara::Parameters&) { return "scara"; }
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
  std::string operator()(const kinematics::Scara::Parameters& scara) {
    return fmt::format(
        "motion::kinematics::Scara::Parameters{{\n"
        "      .proximal = {}, .distal = {},\n      .shoulder_x = {}, .shoulder_y = {},\n"
        "      .elbow_left = {},\n      .inner_radius = {}, .outer_radius = {},\n"
        "      .width = {}, .depth = {}, .height = {},\n      .home_x = {}, .home_y = {},\n"
        "      .end_stop = {{{{{}, {}}}}}}}",
        length(scara.proximal), length(scara.distal), length(scara.shoulder_x),
        length(scara.shoulder_y), scara.elbow_left, length(scara.inner_radius),
        length(scara.outer_radius), length(scara.width), length(scara.depth), length(scara.height),
        length(scara.home_x), length(scara.home_y), length(scara.end_stop[0]),
        length(scara.end_stop[1]));
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
