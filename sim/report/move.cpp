// SPDX-License-Identifier: Apache-2.0
// Places and length of a move in millimetres.
#include <cmath>

#include "sim/report/gcode_path.hpp"

namespace report {

std::array<double, 3> Move::place_mm(double part) const {
  std::array<double, 3> place{};
  for (std::size_t i = 0; i < place.size(); ++i) {
    const double start = millimeters(from[i]), end = millimeters(to[i]);
    place[i] = start + part * (end - start);
  }
  if (arc) {
    const auto on_arc = arc->at(part);
    place[arc->first] = on_arc[0];
    place[arc->second] = on_arc[1];
  }
  if (mesh) place[2] += mesh->correction(place[0], place[1], place[2]);
  return place;
}

double Move::length_mm() const {
  std::array<double, 3> way{};
  for (std::size_t i = 0; i < way.size(); ++i) way[i] = millimeters(to[i] - from[i]);
  if (arc) {
    way[arc->first] = arc->length_mm();
    way[arc->second] = 0;
  }
  return std::hypot(way[0], way[1], way[2]);
}

std::vector<Move> Move::ways() const {
  if (!over) return {*this};
  Move first = *this, second = *this;
  first.to = second.from = *over;
  first.over = second.over = std::nullopt;
  return {first, second};
}

}  // namespace report
