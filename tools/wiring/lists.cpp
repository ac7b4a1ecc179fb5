// SPDX-License-Identifier: Apache-2.0
// Writes the parts list and the netlist.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <tuple>

#include "tools/wiring/outputs.hpp"

namespace wiring {
namespace {

// A value with a comma would be two cells.
std::string cell(std::string text) {
  std::ranges::replace(text, ',', ';');
  return text;
}

std::string quoted(const std::string& text) {
  std::string words = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') words += '\\';
    words += c;
  }
  return words + "\"";
}

// KiCad's name for a net: a port's index is no bus.
std::string net_name(std::string net) {
  std::erase(net, ']');
  std::ranges::replace(net, '[', '_');
  return net;
}

std::string spoken(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

// By it KiCad knows a component again. Two hashes of 64 bits (FNV-1a) in the form of a UUID, so
// that a designator always has the same.
std::string time_stamp(const std::string& designator) {
  const auto hash = [&designator](std::uint64_t value) {
    constexpr std::uint64_t prime = 0x100'0000'01b3;
    for (const char c : designator) value = (value ^ static_cast<unsigned char>(c)) * prime;
    return value;
  };
  const std::string digits =
      fmt::format("{:016x}{:016x}", hash(0xcbf2'9ce4'8422'2325), hash(0x8422'2325'cbf2'9ce4));
  return fmt::format("{}-{}-{}-{}-{}", digits.substr(0, 8), digits.substr(8, 4),
                     digits.substr(12, 4), digits.substr(16, 4), digits.substr(20));
}

std::string components(const Description& description) {
  std::string text = "  (components\n";
  for (const Part* part : description.parts()) {
    const Kind& kind = description.kind_of(*part);
    text += fmt::format("    (comp (ref {})\n      (value {})\n", quoted(part->designator),
                        quoted(description.value_of(*part).text()));
    text += fmt::format("      (footprint {})\n", quoted(kind.footprint));
    text += fmt::format(
        "      (libsource (lib \"stepfabric\") (part {}) (description {}))\n"
        "      (sheetpath (names \"/\") (tstamps \"/\"))\n"
        "      (tstamps {}))\n",
        quoted(kind.name), quoted(spoken(kind.name)), quoted(time_stamp(part->designator)));
  }
  return text + "  )\n";
}

std::string library(const Description& description) {
  std::string text = "  (libparts\n";
  for (const Kind& kind : description.kinds) {
    text += fmt::format("    (libpart (lib \"stepfabric\") (part {})\n      (pins\n",
                        quoted(kind.name));
    for (const Pin& pin : kind.pins) {
      text += fmt::format("        (pin (num {}) (name {}) (type \"passive\"))\n",
                          quoted(pin.number), quoted(pin.name));
    }
    text += "      ))\n";
  }
  return text + "  )\n";
}

}  // namespace

std::string parts_list(const Description& description) {
  using Key = std::tuple<std::string, std::string, std::string>;
  std::map<Key, std::vector<std::string>> rows;
  std::vector<Key> order;
  for (const Part* part : description.parts()) {
    const Kind& kind = description.kind_of(*part);
    const Key key{spoken(kind.name), description.value_of(*part).text(), kind.footprint};
    if (!rows.contains(key)) order.push_back(key);
    rows[key].push_back(part->designator);
  }
  std::string text = "count,part,value,footprint,designators\n";
  for (const Key& key : order) {
    const auto& [kind, value, footprint] = key;
    text += fmt::format("{},{},{},{},{}\n", rows[key].size(), kind, cell(value), cell(footprint),
                        fmt::join(rows[key], " "));
  }
  return text;
}

std::string netlist(const Description& description) {
  std::map<std::string, std::vector<std::string>> nets;
  for (const Part* part : description.parts()) {
    const Kind& kind = description.kind_of(*part);
    for (std::size_t i = 0; i < part->nets.size(); ++i) {
      nets[net_name(part->nets[i])].push_back(
          fmt::format("      (node (ref {}) (pin {}) (pintype \"passive\"))\n",
                      quoted(part->designator), quoted(kind.pins[i].number)));
    }
  }
  std::string text =
      "(export (version \"E\")\n"
      "  (design\n"
      "    (source \"boards/interface/interface.toml\")\n"
      "    (tool \"StepFabric tools/wiring\"))\n";
  text += components(description) + library(description) + "  (nets\n";
  int code = 0;
  for (const auto& [net, nodes] : nets) {
    text += fmt::format("    (net (code \"{}\") (name {})\n{}    )\n", ++code, quoted(net),
                        fmt::join(nodes, ""));
  }
  return text + "  ))\n";
}

}  // namespace wiring
