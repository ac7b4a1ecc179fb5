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
};

struct Text {
  std::string operator()(const kinematics::Cartesian::Parameters&) { return {}; }
  std::string operator()(const kinematics::CoreXy::Parameters&) {
    return "motion::kinematics::CoreXy::Parameters{}";
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
