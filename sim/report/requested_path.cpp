// SPDX-License-Identifier: Apache-2.0
// Reads the answered lines, executed or refused.
#include "sim/report/requested_path.hpp"

namespace report {

void RequestedPath::command_acknowledged(sim::Clock now, std::size_t file_line,
                                         std::string_view command, bool executed) {
  GcodePath unchanged = gcode_;
  const Request request = executed ? gcode_.read(command) : unchanged.read(command);
  const Move* move = std::get_if<Move>(&request);
  if (move == nullptr) return;
  RequestedMove line{.file_line = file_line,
                     .seconds = rate_.seconds(now),
                     .extrudes = move->to[3] > move->from[3],
                     .executed = executed};
  for (std::size_t i = 0; i < line.from.size(); ++i) {
    line.from[i] = static_cast<float>(millimeters(move->from[i]));
    line.to[i] = static_cast<float>(millimeters(move->to[i]));
  }
  lines_.push_back(line);
}

}  // namespace report
