// SPDX-License-Identifier: Apache-2.0
// Reads a board's tables, its top entity's ports, and the pin constraints that are generated.
#include "tests/synthesis/board_pins.hpp"

#include <fstream>
#include <regex>
#include <sstream>

#include "tools/process/process.hpp"

namespace synthesis {
namespace {

// A line of Quartus' assignments.
bool read_assignment(const std::string& line, Constraints& constraints) {
  static const std::regex place(R"re(set_location_assignment PIN_(\w+) -to \{([^}]+)\})re");
  static const std::regex assignment(
      R"re(set_instance_assignment -name (\w+) "([^"]+)" -to \{([^}]+)\})re");
  std::smatch match;
  if (std::regex_match(line, match, place)) {
    ConstrainedPin& pin = constraints.pins[match[2]];
    if (!pin.site.empty()) constraints.refusal = "two places: " + line;
    pin.site = match[1];
  } else if (std::regex_match(line, match, assignment)) {
    std::string& value = constraints.pins[match[3]].attributes[match[1]];
    if (!value.empty()) constraints.refusal = "said twice: " + line;
    value = match[2];
  } else {
    return false;
  }
  return true;
}

void read_line(const std::string& line, Constraints& constraints) {
  static const std::regex place(R"re(LOCATE COMP "([^"]+)" SITE "(\w+)";)re");
  static const std::regex buffer(R"re(IOBUF PORT "([^"]+)"(( \w+=\w+)+);)re");
  std::smatch match;
  if (std::regex_match(line, match, place)) {
    ConstrainedPin& pin = constraints.pins[match[1]];
    if (!pin.site.empty()) constraints.refusal = "two places: " + line;
    pin.site = match[2];
  } else if (std::regex_match(line, match, buffer)) {
    ConstrainedPin& pin = constraints.pins[match[1]];
    if (!pin.attributes.empty()) constraints.refusal = "two buffers: " + line;
    std::istringstream words(match[2]);
    std::string word;
    while (words >> word) {
      const std::size_t equals = word.find('=');
      pin.attributes[word.substr(0, equals)] = word.substr(equals + 1);
    }
  } else if (!read_assignment(line, constraints)) {
    constraints.refusal = "not understood: " + line;
  }
}

}  // namespace

Constraints generate_constraints(const std::filesystem::path& project, const std::string& board) {
  const std::string script = (project / "tools/hardware/write_constraints.sh").string();
  const auto [status, text] = process::capture({.arguments = {script, project.string(), board}});
  Constraints constraints;
  if (status != 0) {
    constraints.refusal = text;
    return constraints;
  }
  std::istringstream lines(text);
  std::string line;
  while (std::getline(lines, line)) read_line(line, constraints);
  return constraints;
}

std::map<std::string, std::string> ports_of(const std::filesystem::path& entity) {
  static const std::regex port(
      R"(\s+(\w+) : (in|out) std_u?logic(_vector\((\d+) downto 0\))?;?\s*)");
  std::ifstream stream(entity);
  std::map<std::string, std::string> ports;
  std::string line;
  while (std::getline(stream, line) && !line.starts_with("end entity")) {
    std::smatch match;
    if (!std::regex_match(line, match, port)) continue;
    if (!match[3].matched) {
      ports[match[1]] = match[2];
      continue;
    }
    for (int index = 0; index <= std::stoi(match[4]); ++index) {
      ports[match[1].str() + "[" + std::to_string(index) + "]"] = match[2];
    }
  }
  return ports;
}

std::string signal_of(const std::string& port) { return port.substr(0, port.find('[')); }

}  // namespace synthesis
