// SPDX-License-Identifier: Apache-2.0
// The lines of yosys-smtbmc that matter.
#include "tools/proof/solver_log.hpp"

#include <regex>
#include <sstream>

namespace proof {

SolverLog read_solver_log(std::string_view text) {
  static const std::regex step_line(R"(.*Checking assertions in step (\d+).*)");
  static const std::regex failure_line(R"(.*Assert failed in ([^:]+): (\S+).*)");
  SolverLog log;
  std::istringstream stream{std::string(text)};
  std::smatch match;
  for (std::string line; std::getline(stream, line);) {
    if (std::regex_match(line, match, step_line)) {
      log.failed_at = std::stoi(match[1]);
    } else if (std::regex_match(line, match, failure_line)) {
      const std::string path = match[1];
      const std::size_t instance = path.find('.');
      log.failed.push_back(instance == std::string::npos
                               ? match[2].str()
                               : path.substr(instance + 1) + "." + match[2].str());
    } else if (line.find("Status: PASSED") != std::string::npos) {
      log.holds = true;
    } else if (line.find("Status: FAILED") != std::string::npos) {
      log.holds = false;
    }
  }
  return log;
}

std::set<std::string> read_solutions(std::string_view text) {
  // "  CLOCK SIGNAL DECIMAL HEXADECIMAL BINARY", without the last three columns for "init".
  static const std::regex value_line(R"( +(\d+) (\S+) +\S+ +\S+ +([01]+) *)");
  std::set<std::string> solutions;
  std::istringstream stream{std::string(text)};
  int clock = 0;
  std::string values;
  const auto finish = [&] {
    if (values.find('1') != std::string::npos) solutions.insert(values);
    values.clear();
  };
  std::smatch match;
  for (std::string line; std::getline(stream, line);) {
    if (line.find("model found") != std::string::npos) {
      finish();
      clock = 0;
    } else if (std::regex_match(line, match, value_line)) {
      if (const int now = std::stoi(match[1]); now != clock) {
        clock = now;
        values.clear();
      }
      values += match[3].str() + " ";
    }
  }
  finish();
  return solutions;
}

}  // namespace proof
