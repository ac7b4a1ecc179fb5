// SPDX-License-Identifier: Apache-2.0
// What a machine with a probe has in memory besides: probe, mesh, and the line above it.
#pragma once

#include "motion/bed_mesh.hpp"
#include "motion/levelled_line.hpp"
#include "motion/probing.hpp"

namespace motion {

// In the machine description.
struct LevellingSettings {
  ProbeSettings probe{};
  MeshSettings mesh{};
};

struct Levelling {
  ProbeSettings probe{};  // with the offset of M851
  BedMesh mesh;
  Probing probing;
  LevelledLine line;  // of the last move
  // Lines follow the mesh. Then this is where the last one ends, without its correction.
  bool active{};
  units::PerAxis<units::Position> place{};
  bool line_is_before_stretch{};  // MotionTask::set_stretch
};

}  // namespace motion
