// SPDX-License-Identifier: Apache-2.0
// The state of bed levelling that a file has brought about: the mesh, and whether lines follow it.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>

#include "sim/report/bed_mesh.hpp"
#include "sim/report/femtometers.hpp"

namespace report {

// A probe, the simulated bed under it, and the mesh, as the machine's description has them.
struct ProbeFacts {
  std::array<double, 3> offset_mm{};  // of M851
  double clearance_mm{};
  std::array<MeshLines, 2> lines{};
  double fade_height_mm{};
  std::function<double(double x, double y)> bed_mm;  // its height above Z = 0
};

class Levelling {
 public:
  Levelling() = default;
  explicit Levelling(const ProbeFacts& probe)
      : offset_mm(probe.offset_mm), mesh(probe.lines, probe.fade_height_mm) {}

  bool active() const { return followed_ != nullptr; }
  // What lines follow from now on: the mesh as it is, or none.
  void follow(bool follows) { followed_ = follows ? std::make_shared<BedMesh>(mesh) : nullptr; }
  const std::shared_ptr<const BedMesh>& followed() const { return followed_; }

  std::array<double, 3> offset_mm{};
  BedMesh mesh;

 private:
  std::shared_ptr<const BedMesh> followed_;
};

// In millimetres, to femtometres.
Femtometers femtometers(double millimeters);

// Where the nozzle is, for a place of which Z is above the mesh, if there is one.
template <class Place>
Place above(const std::shared_ptr<const BedMesh>& mesh, Place place) {
  if (mesh) {
    place[2] += femtometers(
        mesh->correction(millimeters(place[0]), millimeters(place[1]), millimeters(place[2])));
  }
  return place;
}

}  // namespace report
