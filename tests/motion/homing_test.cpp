// SPDX-License-Identifier: Apache-2.0
// Homing against axes with end stops that are simulated in nanometres.
#include "motion/homing.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <vector>

#include "tests/motion/machine.hpp"

namespace {

using motion::Fault;
using motion::Homing;
using motion::HomingRequest;
using motion_test::mendel;
using units::Axis;

constexpr std::int64_t mm = 1'000'000;
using Kind = HomingRequest::Kind;

// Carriages that stop where their end stop switches; moves are executed in one go.
class Carriages {
 public:
  units::PerAxis<std::int64_t> position{50 * mm, 60 * mm, 70 * mm, 0};
  units::PerAxis<bool> broken{};  // never switches
  std::uint8_t stuck{};  // always pressed
  std::vector<HomingRequest> requests;

  HomingRequest home(units::AxisSet axes, const motion::Limits& limits) {
    Homing homing;
    homing.start(axes, limits);
    bool stopped = false;
    while (homing.active()) {
      const HomingRequest busy =
          homing.update({.at_rest = false, .stopped = true, .end_stops = levels()});
      EXPECT_EQ(busy.kind, Kind::nothing);
      const HomingRequest request =
          homing.update({.at_rest = true, .stopped = stopped, .end_stops = levels()});
      requests.push_back(request);
      if (request.kind == Kind::move) stopped = execute(request.move);
      if (request.kind == Kind::finished || request.kind == Kind::fault) return request;
      if (requests.size() > 100) break;
    }
    return {};
  }

  std::vector<Axis> homed() const {
    std::vector<Axis> axes;
    for (const HomingRequest& request : requests) {
      if (request.kind == Kind::set_position) axes.push_back(request.axis);
    }
    return axes;
  }

 private:
  std::uint8_t levels() const {
    unsigned bits = stuck;
    for (std::size_t i = 0; i < 3; ++i) {
      if (position[i] <= 0 && !broken[i]) bits |= 1u << i;
    }
    return static_cast<std::uint8_t>(bits);
  }

  bool execute(const motion::HomingMove& move) {
    const std::size_t i = units::index_of(move.axis);
    const std::int64_t target = position[i] + move.distance.count();
    const bool watches = (move.stop_mask >> i & 1u) != 0 && !broken[i];
    const bool stops = watches && target <= 0;
    position[i] = stops ? std::min<std::int64_t>(position[i], 0) : target;
    return stops;
  }
};

TEST(homing, finds_all_end_stops_one_after_another) {
  Carriages carriages;
  const HomingRequest last = carriages.home(units::AxisSet::all(), mendel());
  EXPECT_EQ(last.kind, Kind::finished);
  EXPECT_THAT(carriages.homed(), testing::ElementsAre(Axis::x, Axis::y, Axis::z));
  EXPECT_THAT(carriages.position, testing::ElementsAre(0, 0, 0, 0));
}

// Motors that go together are as fast as the slowest of them may be; Z homes at 8 mm/s.
TEST(homing, of_all_motors_together_keeps_the_speed_of_each) {
  Homing homing;
  homing.start(units::AxisSet::all(), mendel(), true);
  const HomingRequest request = homing.update({.at_rest = true});
  ASSERT_EQ(request.kind, Kind::move);
  EXPECT_TRUE(request.move.together);
  EXPECT_EQ(request.move.speed.count(), 8'000);
  EXPECT_EQ(request.move.distance.count(), -205 * mm);
  EXPECT_EQ(request.move.stop_mask, 0b111);
}

TEST(homing, approaches_fast_backs_off_and_approaches_slowly) {
  Carriages carriages;
  units::AxisSet axes;
  axes.insert(Axis::x);
  EXPECT_EQ(carriages.home(axes, mendel()).kind, Kind::finished);
  ASSERT_EQ(carriages.requests.size(), 5u);
  const auto& fast = carriages.requests[0].move;
  EXPECT_EQ(fast.distance, units::Nanometers(-205 * mm));
  EXPECT_EQ(fast.speed, units::MicrometersPerSecond(50'000));
  EXPECT_EQ(fast.stop_mask, 1);
  const auto& back = carriages.requests[1].move;
  EXPECT_EQ(back.distance, units::Nanometers(5 * mm));
  EXPECT_EQ(back.stop_mask, 0);
  const auto& slow = carriages.requests[2].move;
  EXPECT_EQ(slow.distance, units::Nanometers(-10 * mm));
  EXPECT_EQ(slow.speed, units::MicrometersPerSecond(5'000));
  EXPECT_EQ(slow.stop_mask, 1);
  EXPECT_EQ(carriages.requests[3].kind, Kind::set_position);
  EXPECT_EQ(carriages.requests[3].position, units::Nanometers(0));
}

TEST(homing, moves_only_the_axes_asked_for) {
  Carriages carriages;
  units::AxisSet axes;
  axes.insert(Axis::y);
  axes.insert(Axis::e);  // has no end stop
  EXPECT_EQ(carriages.home(axes, mendel()).kind, Kind::finished);
  EXPECT_THAT(carriages.homed(), testing::ElementsAre(Axis::y));
  EXPECT_THAT(carriages.position, testing::ElementsAre(50 * mm, 0, 70 * mm, 0));
}

TEST(homing, releases_an_end_stop_that_is_already_pressed) {
  Carriages carriages;
  carriages.position[0] = -1 * mm;
  units::AxisSet axes;
  axes.insert(Axis::x);
  EXPECT_EQ(carriages.home(axes, mendel()).kind, Kind::finished);
  EXPECT_EQ(carriages.requests[0].move.distance, units::Nanometers(5 * mm));
  EXPECT_EQ(carriages.position[0], 0);
}

TEST(homing, gives_up_when_the_end_stop_is_never_found) {
  Carriages carriages;
  carriages.broken[1] = true;
  const HomingRequest last = carriages.home(units::AxisSet::all(), mendel());
  EXPECT_EQ(last.kind, Kind::fault);
  EXPECT_EQ(last.fault, Fault::end_stop_not_found);
  EXPECT_EQ(last.axis, Axis::y);
  EXPECT_THAT(carriages.homed(), testing::ElementsAre(Axis::x));
  EXPECT_EQ(carriages.position[2], 70 * mm);
}

TEST(homing, pushes_no_farther_than_the_travel_and_a_back_off) {
  for (const std::int64_t travel : {0, 30, 200}) {
    motion::Limits limits = mendel();
    limits.of(Axis::x).travel = units::Nanometers(travel * mm);
    Carriages carriages;
    carriages.broken[0] = true;
    carriages.position[0] = 0;
    units::AxisSet axes;
    axes.insert(Axis::x);
    EXPECT_EQ(carriages.home(axes, limits).fault, Fault::end_stop_not_found);
    EXPECT_EQ(carriages.position[0], -(travel + 5) * mm);
  }
}

TEST(homing, goes_no_farther_than_twice_the_back_off_after_a_release) {
  Carriages carriages;
  carriages.position[0] = -1 * mm;
  units::AxisSet axes;
  axes.insert(Axis::x);
  carriages.home(axes, mendel());
  EXPECT_EQ(carriages.requests[1].move.distance, units::Nanometers(-10 * mm));
}

TEST(homing, gives_up_when_the_end_stop_does_not_open) {
  Carriages carriages;
  carriages.stuck = 1u << 2;
  const HomingRequest last = carriages.home(units::AxisSet::all(), mendel());
  EXPECT_EQ(last.kind, Kind::fault);
  EXPECT_EQ(last.fault, Fault::end_stop_stuck);
  EXPECT_EQ(last.axis, Axis::z);
}

TEST(homing, goes_towards_the_positive_side_where_the_end_stop_lies_there) {
  motion::Limits limits = mendel();
  limits.of(Axis::x).homing->towards_positive = true;
  limits.of(Axis::x).homing->position = units::Nanometers(200 * mm);
  Homing homing;
  units::AxisSet axes;
  axes.insert(Axis::x);
  homing.start(axes, limits);
  EXPECT_GT(homing.update({.at_rest = true}).move.distance, units::Nanometers(0));
  EXPECT_LT(homing.update({.at_rest = true, .stopped = true}).move.distance, units::Nanometers(0));
  EXPECT_GT(homing.update({.at_rest = true}).move.distance, units::Nanometers(0));
  EXPECT_EQ(homing.update({.at_rest = true, .stopped = true}).position,
            units::Nanometers(200 * mm));
}

TEST(homing, is_quiet_after_a_cancel) {
  Homing homing;
  homing.start(units::AxisSet::all(), mendel());
  EXPECT_EQ(homing.update({.at_rest = true}).kind, Kind::move);
  homing.cancel();
  EXPECT_FALSE(homing.active());
  EXPECT_EQ(homing.update({.at_rest = true}).kind, Kind::nothing);
}

}  // namespace
