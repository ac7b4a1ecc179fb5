// SPDX-License-Identifier: Apache-2.0
// The kinematics of whatever machine is given at run time, for tests and tools on the host.
#pragma once

#include <variant>

#include "motion/kinematics/cartesian.hpp"
#include "motion/kinematics/core_xy.hpp"
#include "motion/kinematics/delta.hpp"
#include "motion/kinematics/scara.hpp"

namespace motion::kinematics {

class Any {
  using Models = std::variant<Cartesian, CoreXy, Delta, Scara>;

  struct MakeModel {
    Models operator()(const Cartesian::Parameters& parameters) const {
      return Cartesian(parameters);
    }
    Models operator()(const CoreXy::Parameters& parameters) const { return CoreXy(parameters); }
    Models operator()(const Delta::Parameters& parameters) const { return Delta(parameters); }
    Models operator()(const Scara::Parameters& parameters) const { return Scara(parameters); }
  };

  template <class Function>
  auto visit(Function function) const {
    return std::visit(function, model_);
  }

 public:
  using Parameters =
      std::variant<Cartesian::Parameters, CoreXy::Parameters, Delta::Parameters, Scara::Parameters>;

  Any() = default;
  explicit Any(const Parameters& parameters) : model_(std::visit(MakeModel(), parameters)) {}

  static constexpr bool may_be_delta = true;
  static constexpr bool may_home_motors = true;
  using Chords = Division;

  // For tools that model the machine.
  bool crosses_xy() const { return std::holds_alternative<CoreXy>(model_); }
  bool has_own_z() const { return !std::holds_alternative<Delta>(model_); }

  const Delta* delta() const { return std::get_if<Delta>(&model_); }
  bool identity() const {
    return visit([](const auto& model) { return model.identity(); });
  }
  bool straight() const {
    return visit([](const auto& model) { return model.straight(); });
  }
  bool homes_motors() const {
    return visit([](const auto& model) { return model.homes_motors(); });
  }
  std::size_t curved_motors() const {
    return visit([](const auto& model) { return model.curved_motors(); });
  }
  std::string_view motor_letters() const {
    return visit([](const auto& model) { return model.motor_letters(); });
  }
  bool reaches(const Place& tool) const {
    return visit([&](const auto& model) { return model.reaches(tool); });
  }
  bool straight_within(const Place& from, const Place& to) const {
    return visit([&](const auto& model) { return model.straight_within(from, to); });
  }
  Place motors_of(const Place& tool) const {
    return visit([&](const auto& model) -> Place { return model.motors_of(tool); });
  }
  Place place_of(const Place& motors) const {
    return visit([&](const auto& model) -> Place { return model.place_of(motors); });
  }
  std::uint32_t chords(const Place& from, const Place& to) const {
    return visit([&](const auto& model) { return model.chords(from, to); });
  }
  units::MicrometersPerSecond speed_limit(const Place& from, const Place& to,
                                          units::MicrometersPerSecondSquared most) const {
    return visit([&](const auto& model) { return model.speed_limit(from, to, most); });
  }
  Home home() const {
    return visit([](const auto& model) { return model.home(); });
  }

 private:
  Models model_;
};

static_assert(Model<Any>);

}  // namespace motion::kinematics
