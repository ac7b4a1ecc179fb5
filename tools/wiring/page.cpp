// SPDX-License-Identifier: Apache-2.0
// Writes the schematic as a page: circuits, values with calculations, facts with their sources.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tools/wiring/outputs.hpp"

namespace wiring {
namespace {

std::string designators_of(const Circuit& circuit, std::size_t part) {
  std::vector<std::string> names;
  for (const auto& copy : circuit.parts) names.push_back(copy[part].designator);
  return fmt::format("{}", fmt::join(names, " "));
}

// Of all copies, where they differ.
std::string values_of(const Description& description, const Circuit& circuit, std::size_t part) {
  std::vector<std::string> values;
  for (const auto& copy : circuit.parts) {
    const std::string text = description.value_of(copy[part]).text();
    if (values.empty() || values.back() != text) values.push_back(text);
  }
  return fmt::format("{}", fmt::join(values, " or "));
}

std::string connections_of(const Description& description, const Part& part) {
  std::vector<std::string> pins;
  const Kind& kind = description.kind_of(part);
  for (std::size_t i = 0; i < part.nets.size(); ++i) {
    pins.push_back(fmt::format("{} `{}`", kind.pins[i].name, part.nets[i]));
  }
  return fmt::format("{}", fmt::join(pins, ", "));
}

std::string chapter(const Description& description, const Circuit& circuit) {
  const bool is_repeated = circuit.copies.size() > 1;
  std::string text = fmt::format(
      "\n## {}{}\n\n{}\n\n", circuit.title,
      is_repeated ? fmt::format(": {}", fmt::join(circuit.copies, ", ")) : std::string(),
      circuit.about);
  text +=
      fmt::format("| part | value | pins{} |\n|---|---|---|\n", is_repeated ? " of the first" : "");
  for (std::size_t part = 0; part < circuit.parts.front().size(); ++part) {
    text += fmt::format("| {} | {} | {} |\n", designators_of(circuit, part),
                        values_of(description, circuit, part),
                        connections_of(description, circuit.parts.front()[part]));
  }
  return text;
}

std::string values(const Description& description, const Numbers& numbers) {
  std::string text =
      "\n## Values\n\nEach with its calculations: what comes out, and what must come out.\n\n"
      "| value | is | why | calculation | gives | must be |\n|---|---|---|---|---|---|\n";
  for (const Value& value : description.values) {
    std::string name = fmt::format("`{}` | {} | {}", value.name, value.text(), value.why);
    if (value.checks.empty()) text += fmt::format("| {} | | | |\n", name);
    for (const Check& check : value.checks) {
      text += fmt::format("| {} | {}: `{}` | {} | at {} {} |\n", name, check.says, check.formula,
                          shown(value_of(check.formula, numbers), check.unit),
                          check.is_upper_limit ? "most" : "least",
                          shown(value_of(check.limit, numbers), check.unit));
      name = " | | ";
    }
  }
  return text;
}

std::string facts(const Description& description, const Numbers& numbers) {
  std::string text =
      "\n## What the calculations start from\n\n| name | is | source |\n|---|---|---|\n";
  for (const Fact& fact : description.facts) {
    text += fmt::format("| `{}` | {} | {} |\n", fact.name, shown(numbers.at(fact.name), fact.unit),
                        fact.source);
  }
  return text;
}

}  // namespace

std::string schematic_page(const Description& description) {
  std::string text =
      "# Interface board: schematic\n\n"
      "Generated from `interface.toml`, `values.toml` and `facts.toml`: do not edit.\n\n"
      "![the circuits](schematic.svg)\n\n"
      "## Header J1\n\n| position | net | position | net |\n|---|---|---|---|\n";
  const auto net_at = [&](std::size_t position) {
    const std::string& net = description.header.nets.at(position - 1);
    return net.empty() ? std::string("unconnected") : fmt::format("`{}`", net);
  };
  for (std::size_t position = 1; position <= description.header.nets.size(); position += 2) {
    text += fmt::format("| {} | {} | {} | {} |\n", position, net_at(position), position + 1,
                        net_at(position + 1));
  }
  for (const Circuit& circuit : description.circuits) text += chapter(description, circuit);
  const Numbers numbers = numbers_of(description);
  return text + values(description, numbers) + facts(description, numbers);
}

}  // namespace wiring
