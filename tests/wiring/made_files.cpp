// SPDX-License-Identifier: Apache-2.0
// Reads the netlist and groups of an SVG.
#include "tests/wiring/made_files.hpp"

#include <algorithm>
#include <regex>
#include <stdexcept>

#include "tests/wiring/s_expression.hpp"
#include "tools/files/file_text.hpp"

namespace wiring_files {
std::string Netlist::net_of(const std::string& pin) const {
  const auto found =
      std::ranges::find_if(pins, [&](const auto& net) { return net.second.contains(pin); });
  return found == pins.end() ? "" : found->first;
}

std::vector<std::string> Netlist::between(char letter, const std::string& one,
                                          const std::string& other) const {
  const auto parts_on = [&](const std::string& net) {
    std::set<std::string> parts;
    const auto found = pins.find(net);
    if (found == pins.end()) return parts;
    for (const std::string& pin : found->second) {
      if (pin.front() == letter) parts.insert(pin.substr(0, pin.find('.')));
    }
    return parts;
  };
  const std::set<std::string> first = parts_on(one), second = parts_on(other);
  std::vector<std::string> both;
  std::ranges::set_intersection(first, second, std::back_inserter(both));
  return both;
}

Netlist read_netlist(const std::filesystem::path& file) {
  const Expression all = read_expression(file);
  Netlist netlist;
  netlist.version = all.text("version");
  const Expression *components = all.find("components"), *nets = all.find("nets");
  if (components == nullptr || nets == nullptr) throw std::runtime_error("a part is missing");
  for (const Expression& component : components->list) {
    if (component.list.empty()) continue;
    netlist.components[component.text("ref")] = {component.text("value"),
                                                 component.text("footprint")};
  }
  for (const Expression& net : nets->list) {
    if (net.list.empty()) continue;
    for (const Expression& node : net.list) {
      if (node.list.empty() || node.list.front().word != "node") continue;
      const std::string ref = node.text("ref"), pin = ref + "." + node.text("pin");
      if (!netlist.components.contains(ref)) throw std::runtime_error("no component " + ref);
      if (!netlist.net_of(pin).empty()) throw std::runtime_error(pin + " is on two nets");
      netlist.pins[net.text("name")].insert(pin);
    }
  }
  return netlist;
}

std::vector<DrawnWire> read_picture(const std::filesystem::path& file) {
  static const std::regex group(
      "<g data-position=\"(\\d+)\" data-net=\"([^\"]*)\" data-signal=\"([^\"]*)\" "
      "data-pin=\"([^\"]*)\">\n((<(?!/g>)[^\n]*\n)*)</g>"),
      words("<text [^>]*>([^<]*)</text>");
  const std::string text = files::text_of(file);
  std::vector<DrawnWire> wires;
  for (std::sregex_iterator match(text.begin(), text.end(), group), end; match != end; ++match) {
    DrawnWire& wire =
        wires.emplace_back(std::stoi((*match)[1]), (*match)[2], (*match)[3], (*match)[4], "");
    const std::string body = (*match)[5];
    for (std::sregex_iterator word(body.begin(), body.end(), words); word != end; ++word) {
      wire.words += (*word)[1].str() + "\n";
    }
  }
  return wires;
}

}  // namespace wiring_files
