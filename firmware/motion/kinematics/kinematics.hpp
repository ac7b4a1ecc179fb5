// SPDX-License-Identifier: Apache-2.0
// What the planner needs to know of how motors move the tool.
#pragma once

#include <concepts>
#include <cstdint>
#include <string_view>

#include "motion/limits.hpp"
#include "units/axes.hpp"
#include "units/position.hpp"

namespace motion::kinematics {

// Of the tool: X, Y, Z and E. Of the motors: of X, Y, Z and E, each in the unit of its steps, a
// millimetre, or a degree where it turns an arm. E is its own motor everywhere.
using Place = units::PerAxis<units::Position>;

inline constexpr std::size_t spatial_axes = 3;

class Delta;

// Where homing ends.
struct Home {
  Place tool{};
  // What a motor still moves after its end stop has switched (M666), before it is at home.
  units::PerAxis<units::Nanometers> behind_end_stop{};
};

// A machine's image is built for one model (machine/kinematics.hpp); what is constant in a model
// costs nothing there. Tests and tools on the host are built for Any.
template <class M>
concept Model =
    std::default_initializable<typename M::Parameters> && requires(typename M::Chords& chords) {
      { chords.done() } -> std::same_as<bool>;
    } && requires(const M& model, const Place& place, const Limits& limits) {
      M(typename M::Parameters{});
      // Each axis has a motor of its own: both functions return what they take.
      { model.identity() } -> std::same_as<bool>;
      // As a delta, whose geometry M665 can change; null where it is none.
      { model.delta() } -> std::convertible_to<const Delta*>;
      // A straight line of the tool is one of the motors: lines need not be cut into chords.
      { model.straight() } -> std::same_as<bool>;
      // Homing moves motors, not axes, and finds all places at once.
      { model.homes_motors() } -> std::same_as<bool>;
      // So many motors, from X on, go along a curve where the tool goes straight.
      { model.curved_motors() } -> std::same_as<std::size_t>;
      // What M114 calls the motors of X, Y and Z.
      { model.motor_letters() } -> std::same_as<std::string_view>;
      // Within what the mechanism reaches, so that motors_of is defined.
      { model.reaches(place) } -> std::same_as<bool>;
      // So is a whole straight line to a place of reach, from where a line has ended.
      { model.straight_within(place, place) } -> std::same_as<bool>;
      // The motors' places for a place of the tool within reach, and back.
      { model.motors_of(place) } -> std::convertible_to<Place>;
      { model.place_of(place) } -> std::convertible_to<Place>;
      // In so many chords, equal in the tool's space, a line stays within chord_deviation.
      { model.chords(place, place) } -> std::same_as<std::uint32_t>;
      // The tool's speed at which the motors' acceleration along a straight line is within this.
      {
        model.speed_limit(place, place, limits.print_acceleration)
      } -> std::same_as<units::MicrometersPerSecond>;
      { model.home() } -> std::same_as<Home>;
    };

// How far the tool may leave its line between the ends of a chord, besides the motors' steps.
inline constexpr units::Nanometers chord_deviation{10'000};

}  // namespace motion::kinematics
