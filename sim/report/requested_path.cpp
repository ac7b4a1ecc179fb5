// SPDX-License-Identifier: Apache-2.0
// Reads the answered lines, executed or refused.
#include "sim/report/requested_path.hpp"

#include <algorithm>
#include <cmath>

namespace report {

namespace {

constexpr double radians_per_chord = 0.1;

int chords_of(const ArcShape& arc) {
  return 1 + static_cast<int>(std::abs(arc.sweep) / radians_per_chord);
}

std::array<float, 3> place_at(const Move& move, double part) {
  const auto place = move.place_mm(part);
  std::array<float, 3> drawn{};
  std::ranges::transform(place, drawn.begin(), [](double mm) { return static_cast<float>(mm); });
  return drawn;
}

}  // namespace

void RequestedPath::command_acknowledged(sim::Clock now, std::size_t file_line,
                                         std::string_view command, bool executed) {
  GcodePath unchanged = gcode_;
  const Request request = executed ? gcode_.read(command) : unchanged.read(command);
  RequestedMove line{.file_line = file_line, .seconds = rate_.seconds(now), .executed = executed};
  if (const Move* move = std::get_if<Move>(&request)) add(*move, line);
  if (const ToolMoves* change = std::get_if<ToolMoves>(&request)) {
    for (const Move& move : change->moves) add(move, line);
  }
}

void RequestedPath::add(const Move& move, RequestedMove line) {
  line.extrudes = move.to[3] > move.from[3] || move.to[4] > move.from[4];
  const int count = move.arc ? chords_of(*move.arc) : 1;
  line.from = place_at(move, 0);
  for (int i = 1; i <= count; ++i) {
    line.to = place_at(move, static_cast<double>(i) / count);
    lines_.push_back(line);
    line.from = line.to;
  }
}

}  // namespace report
