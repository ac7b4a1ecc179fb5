// SPDX-License-Identifier: Apache-2.0
// Paths into JSON, and regular expressions.
#include "tools/figures/selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <ranges>
#include <regex>
#include <stdexcept>
#include <vector>

namespace figures {

namespace {

using Json = nlohmann::json;
using Nodes = std::vector<const Json*>;

std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (const auto part : std::views::split(text, separator)) {
    parts.emplace_back(part.begin(), part.end());
  }
  return parts;
}

std::string text_of(const Json& json) {
  return json.is_string() ? json.get<std::string>() : json.dump();
}

bool meets(const Json& element, const std::string& conditions) {
  return std::ranges::all_of(parts_of(conditions, '&'), [&](const std::string& condition) {
    const std::size_t sign = condition.find('=');
    const auto member = element.find(condition.substr(0, sign));
    return member != element.end() && text_of(*member) == condition.substr(sign + 1);
  });
}

Nodes followed(const Json& node, const std::string& part) {
  Nodes found;
  if (part == "*") {
    for (const Json& element : node) found.push_back(&element);
  } else if (node.is_object()) {
    if (const auto member = node.find(part); member != node.end()) found.push_back(&*member);
  } else if (node.is_array() && part.contains('=')) {
    for (const Json& element : node) {
      if (meets(element, part)) found.push_back(&element);
    }
  } else if (node.is_array()) {
    const std::size_t index = std::stoul(part);
    if (index < node.size()) found.push_back(&node[index]);
  }
  return found;
}

std::optional<double> as_number(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

double combined(const std::string& how, const std::vector<double>& numbers) {
  if (how == "sum") return std::accumulate(numbers.begin(), numbers.end(), 0.0);
  if (how == "max") return std::ranges::max(numbers);
  if (how == "min") return std::ranges::min(numbers);
  throw std::runtime_error(fmt::format("{} is none of sum, max, min, count", how));
}

}  // namespace

double number_at(const Json& json, const std::string& path) {
  const std::size_t slash = path.find('/');
  if (slash == std::string::npos) throw std::runtime_error(fmt::format("{} is no path", path));
  Nodes nodes{&json};
  for (const std::string& part : parts_of(path.substr(slash + 1), '/')) {
    Nodes next;
    for (const Json* node : nodes) {
      std::ranges::copy(followed(*node, part), std::back_inserter(next));
    }
    nodes = next;
  }
  const std::string how = slash == 0 ? "" : path.substr(0, slash - 1);
  if (how == "count") return static_cast<double>(nodes.size());
  if (nodes.empty() || (how.empty() && nodes.size() != 1)) {
    throw std::runtime_error(fmt::format("{} is there {} times", path, nodes.size()));
  }
  std::vector<double> numbers;
  for (const Json* node : nodes) {
    const auto number = as_number(text_of(*node));
    if (!number) throw std::runtime_error(fmt::format("{} is no number: {}", path, node->dump()));
    numbers.push_back(*number);
  }
  return how.empty() ? numbers.front() : combined(how, numbers);
}

double number_in(const std::string& text, const std::string& expression) {
  const std::regex pattern(expression);
  std::optional<double> found;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
    const auto number = as_number((*match)[1]);
    if (!number || (found && *found != *number)) {
      throw std::runtime_error(fmt::format("{} matches {}", expression, (*match)[0].str()));
    }
    found = number;
  }
  if (!found) throw std::runtime_error(fmt::format("{} matches nothing", expression));
  return *found;
}

}  // namespace figures
