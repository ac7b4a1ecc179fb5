// SPDX-License-Identifier: Apache-2.0
// Assigns messages of the chip to the lines that they refer to.
#include "sim/report/refusal_log.hpp"

#include <utility>

#include "sim/report/code_effects.hpp"

namespace report {

namespace {

constexpr std::size_t most_listed = 1000;
constexpr std::size_t most_text = 200;

std::string printable(std::string_view text) {
  std::string result(text.substr(0, most_text));
  for (char& character : result) {
    if (character < ' ' || character > '~') character = '?';
  }
  return result + (text.size() > most_text ? "..." : "");
}

}  // namespace

std::string reason_of(std::string_view remark) {
  for (const std::string_view beginning : {"echo:", " "}) {
    if (remark.starts_with(beginning)) remark.remove_prefix(beginning.size());
  }
  for (const std::string_view repetition : {", not executed", ": \""}) {
    remark = remark.substr(0, remark.find(repetition));
  }
  return remark.empty() ? "no reason given" : printable(remark);
}

void RefusalLog::command_sent(sim::Clock, std::size_t, std::string_view) { ++in_flight_; }

void RefusalLog::reply(sim::Clock, std::string_view line) {
  if (in_flight_ > 0 && line.starts_with("echo:") && !line.starts_with("echo:busy")) remark_ = line;
}

void RefusalLog::command_acknowledged(sim::Clock, std::size_t file_line, std::string_view command,
                                      bool executed) {
  in_flight_ -= in_flight_ > 0 ? 1 : 0;
  const std::string remark = std::exchange(remark_, {});
  const bool prevented = remark.contains("extrusion prevented");
  if ((executed && !prevented) || file_line == 0) return;
  const RefusedLine line{.file_line = file_line,
                         .text = printable(command),
                         .reason = reason_of(remark),
                         .moves_or_heats = prevented || moves_or_heats(command)};
  std::vector<RefusedLine>& list = line.moves_or_heats ? findings_.refused : findings_.warnings;
  ++(line.moves_or_heats ? findings_.refused_count : findings_.warning_count);
  if (list.size() < most_listed) list.push_back(line);
}

void RefusalLog::report_to(Findings& findings) const {
  findings.refused = findings_.refused;
  findings.warnings = findings_.warnings;
  findings.refused_count = findings_.refused_count;
  findings.warning_count = findings_.warning_count;
}

}  // namespace report
