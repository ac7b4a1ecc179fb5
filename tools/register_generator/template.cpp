// SPDX-License-Identifier: Apache-2.0
// Fills text templates line by line.
#include "register_generator/template.hpp"

#include <stdexcept>

namespace register_generator {
namespace {

const std::string& value_of(std::string_view name, const Values& values) {
  const auto found = values.find(name);
  if (found == values.end()) {
    throw std::logic_error("no value for @" + std::string(name) + "@ in a template");
  }
  return found->second;
}

// Takes the first line off `text`, without its end.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line;
}

// The name that is all of a line but for its indentation; empty if there is more, or none.
std::string_view name_alone(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(' ');
  if (begin == std::string_view::npos || line[begin] != '@') return {};
  const std::string_view name = line.substr(begin + 1);
  return name.find('@') == name.size() - 1 ? name.substr(0, name.size() - 1) : std::string_view{};
}

std::string filled_line(std::string_view line, const Values& values) {
  std::string filled;
  for (std::size_t begin; (begin = line.find('@')) != std::string_view::npos;) {
    const std::size_t end = line.find('@', begin + 1);
    if (end == std::string_view::npos) throw std::logic_error("a single @ in a template");
    filled += line.substr(0, begin);
    filled += value_of(line.substr(begin + 1, end - begin - 1), values);
    line.remove_prefix(end + 1);
  }
  return filled.append(line);
}

}  // namespace

std::string fill(std::string_view text, const Values& values) {
  std::string filled;
  while (!text.empty()) {
    const std::string_view line = take_line(text);
    const std::string_view name = name_alone(line);
    if (name.empty()) {
      filled += filled_line(line, values) + '\n';
      continue;
    }
    const std::string indentation(line.find('@'), ' ');
    std::string_view lines = value_of(name, values);
    while (!lines.empty()) {
      const std::string_view part = take_line(lines);
      if (!part.empty()) filled.append(indentation).append(part);
      filled += '\n';
    }
  }
  return filled;
}

}  // namespace register_generator
