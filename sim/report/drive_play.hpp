// SPDX-License-Identifier: Apache-2.0
// Where axes stand whose drives have play: what a firmware assumes that takes it up (M425).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace report {

// In steps. An axis moves while its motor pushes it, and stays while the motor crosses the play.
class DrivePlay {
 public:
  // The axis after its motor has moved.
  std::int64_t follow(std::size_t axis, std::int64_t motor) {
    Drive& drive = drives_.at(axis);
    drive.motor = motor;
    const std::int64_t pushed_forward = motor - drive.behind - drive.play;
    const std::int64_t pushed_back = motor - drive.behind;
    if (pushed_forward > drive.place) drive.place = pushed_forward;
    if (pushed_back < drive.place) drive.place = pushed_back;
    return drive.place;
  }
  // The axis stays, and the side on which it is pushed.
  void set_play(std::size_t axis, std::int64_t play) {
    Drive& drive = drives_.at(axis);
    if (drive.place < drive.motor - drive.behind) drive.behind += drive.play - play;
    drive.play = play;
  }
  // The motor stands here with its axis, which it has pushed back.
  void start(std::size_t axis, std::int64_t motor) {
    drives_.at(axis) = {motor, motor, 0, drives_.at(axis).play};
  }
  // The same where it is.
  std::int64_t push_back(std::size_t axis) {
    start(axis, drives_.at(axis).motor);
    return drives_.at(axis).place;
  }

 private:
  struct Drive {
    std::int64_t motor{}, place{};
    std::int64_t behind{};  // of the axis while it is pushed back
    std::int64_t play{};
  };
  std::array<Drive, 3> drives_{};
};

}  // namespace report
