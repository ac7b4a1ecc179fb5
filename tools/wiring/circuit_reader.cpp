// SPDX-License-Identifier: Apache-2.0
// Reads kinds of parts, the header and the circuits, and makes the copies.
#include "tools/wiring/circuit_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

namespace wiring {
namespace {

constexpr int designators_per_copy = 10;

Kind kind_of(const TomlReader& reader) {
  reader.only({"name", "prefix", "symbol", "footprint", "pins", "left", "right"});
  Kind kind{.name = reader.text("name"),
            .prefix = reader.text("prefix"),
            .symbol = reader.text("symbol"),
            .footprint = reader.text("footprint"),
            .pins = {},
            .left = {},
            .right = {}};
  for (const std::string& pin : reader.texts("pins")) {
    const std::size_t space = pin.find(' ');
    kind.pins.push_back(
        {pin.substr(0, space), pin.substr(space == std::string::npos ? 0 : space + 1)});
  }
  if (reader.has("left")) kind.left = reader.texts("left");
  if (reader.has("right")) kind.right = reader.texts("right");
  if (kind.symbol == "box" && kind.left.size() + kind.right.size() != kind.pins.size()) {
    reader.fail("the picture lacks a pin");
  }
  return kind;
}

template <class List>
std::size_t index_of(const TomlReader& reader, const List& list, const std::string& name) {
  const auto found = std::ranges::find_if(list, [&](const auto& one) { return one.name == name; });
  if (found == list.end()) reader.fail(fmt::format("there is no '{}'", name));
  return static_cast<std::size_t>(found - list.begin());
}

Place place_of(const TomlReader& reader, const char* key) {
  const std::vector<double> numbers = reader.numbers(key);
  if (numbers.size() != 2) reader.fail(fmt::format("'{}' must be two numbers", key));
  return {numbers[0], numbers[1]};
}

// The net of a copy: "step[#]" is step[1] in the second, "resistor[#3+2]" resistor[5].
std::string net_of(const std::string& pattern, std::size_t copy) {
  static const std::regex multiple(R"((.*)#(\d+)\+(\d+)(.*))"), single("#");
  std::smatch match;
  if (std::regex_match(pattern, match, multiple)) {
    return fmt::format("{}{}{}", match[1].str(), copy * std::stoul(match[2]) + std::stoul(match[3]),
                       match[4].str());
  }
  return std::regex_replace(pattern, single, fmt::format("{}", copy));
}

Part part_of(const TomlReader& reader, const Description& description, std::size_t copy,
             int first) {
  reader.only({"ref", "kind", "value", "at", "turn", "mirror", "pins"});
  Part part;
  part.kind = index_of(reader, description.kinds, reader.text("kind"));
  const Kind& kind = description.kinds[part.kind];
  const std::string ref = reader.text("ref");
  if (!ref.starts_with(kind.prefix) || ref.size() != kind.prefix.size() + 1) {
    reader.fail(fmt::format("a {} is called {} and a digit", kind.name, kind.prefix));
  }
  const int digit = ref.back() - '0';
  part.designator = fmt::format("{}{}", kind.prefix,
                                first + designators_per_copy * static_cast<int>(copy) + digit);
  // Copies may have parts of different values.
  const std::string value = [&] {
    try {
      return reader.texts("value").at(copy);
    } catch (const std::runtime_error&) {
      return reader.text("value");
    }
  }();
  part.value = index_of(reader, description.values, value);
  const std::vector<std::string> nets = reader.texts("pins");
  if (nets.size() != kind.pins.size()) {
    reader.fail(fmt::format("a {} has {} pins; {} are connected", kind.name, kind.pins.size(),
                            nets.size()));
  }
  for (const std::string& net : nets) part.nets.push_back(net_of(net, copy));
  part.at = place_of(reader, "at");
  part.is_turned = reader.number_or("turn", 0) != 0;
  part.is_mirrored = reader.flag("mirror");
  return part;
}

Circuit circuit_of(const TomlReader& reader, const Description& description) {
  reader.only({"name", "title", "copies", "first", "size", "about", "ports", "parts"});
  Circuit circuit;
  circuit.name = reader.text("name");
  circuit.title = reader.text("title");
  circuit.about = reader.text("about");
  circuit.copies = reader.texts("copies");
  circuit.size = place_of(reader, "size");
  for (const TomlReader& port : reader.tables("ports")) {
    port.only({"net", "at"});
    circuit.ports.push_back({net_of(port.text("net"), 0), place_of(port, "at")});
  }
  const int first = static_cast<int>(reader.number("first"));
  for (std::size_t copy = 0; copy < circuit.copies.size(); ++copy) {
    auto& parts = circuit.parts.emplace_back();
    for (const TomlReader& part : reader.tables("parts")) {
      parts.push_back(part_of(part, description, copy, first));
    }
  }
  return circuit;
}

// The header's kind is made of its positions.
void read_header(const TomlReader& reader, Description& description) {
  reader.only({"ref", "value", "footprint", "nets", "unconnected"});
  Header& header = description.header;
  header.nets = reader.texts("nets");
  Kind kind{.name = "header",
            .prefix = "J",
            .symbol = "header",
            .footprint = reader.text("footprint"),
            .pins = {},
            .left = {},
            .right = {}};
  for (std::size_t i = 0; i < header.nets.size(); ++i) {
    const std::string position = fmt::format("{}", i + 1);
    if (header.nets[i].empty()) continue;
    kind.pins.push_back({position, position});
    header.part.nets.push_back(header.nets[i]);
  }
  for (const double position : reader.numbers("unconnected")) {
    header.unconnected.push_back(static_cast<int>(position));
  }
  header.part.designator = reader.text("ref");
  header.part.value = index_of(reader, description.values, reader.text("value"));
  header.part.kind = description.kinds.size();
  description.kinds.push_back(std::move(kind));
}

}  // namespace

void read_circuits(const TomlReader& reader, Description& description) {
  for (const TomlReader& kind : reader.tables("kinds")) description.kinds.push_back(kind_of(kind));
  read_header(reader.table("header"), description);
  for (const TomlReader& circuit : reader.tables("circuit")) {
    description.circuits.push_back(circuit_of(circuit, description));
  }
}

}  // namespace wiring
