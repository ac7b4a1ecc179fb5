// SPDX-License-Identifier: Apache-2.0
// The kinematics of whatever machine is given at run time, for tests and tools on the host.
#pragma once

#include <variant>

#include "motion/kinematics/cartesian.hpp"
#include "motion/kinematics/core_xy.hpp"

namespace motion::kinematics {

class Any {
  using Models = std::variant<Cartesian, CoreXy>;

  struct MakeModel {
    constexpr Models operator()(const Cartesian::Parameters& parameters) const {
      return Cartesian(parameters);
    }
    constexpr Models operator()(const CoreXy::Parameters& parameters) const {
      return CoreXy(parameters);
    }
  };

  template <class Function>
  constexpr auto visit(Function function) const {
    return std::visit(function, model_);
  }

 public:
  using Parameters = std::variant<Cartesian::Parameters, CoreXy::Parameters>;

  constexpr Any() = default;
  explicit constexpr Any(const Parameters& parameters)
      : model_(std::visit(MakeModel(), parameters)) {}

  // For tools that model the machine.
  constexpr bool crosses_xy() const { return std::holds_alternative<CoreXy>(model_); }
  constexpr bool has_own_z() const {
    return std::holds_alternative<Cartesian>(model_) || crosses_xy();
  }

  constexpr bool identity() const {
    return visit([](const auto& model) { return model.identity(); });
  }
  constexpr bool straight() const {
    return visit([](const auto& model) { return model.straight(); });
  }
  constexpr bool homes_motors() const {
    return visit([](const auto& model) { return model.homes_motors(); });
  }
  constexpr std::string_view motor_letters() const {
    return visit([](const auto& model) { return model.motor_letters(); });
  }
  constexpr bool reaches(const Place& tool) const {
    return visit([&](const auto& model) { return model.reaches(tool); });
  }
  constexpr Place motors_of(const Place& tool) const {
    return visit([&](const auto& model) -> Place { return model.motors_of(tool); });
  }
  constexpr Place place_of(const Place& motors) const {
    return visit([&](const auto& model) -> Place { return model.place_of(motors); });
  }
  constexpr std::uint32_t chords(const Place& from, const Place& to) const {
    return visit([&](const auto& model) { return model.chords(from, to); });
  }
  constexpr Home home() const {
    return visit([](const auto& model) { return model.home(); });
  }

 private:
  Models model_;
};

static_assert(Model<Any>);

}  // namespace motion::kinematics
