// SPDX-License-Identifier: Apache-2.0
// The interface board's netlist is one that KiCad's board editor imports: the form that its reader
// (pcbnew/netlist_reader/kicad_netlist_reader.cpp of KiCad 6) expects, and no part of it lost.
#include <gmock/gmock.h>

#include <fstream>
#include <map>
#include <regex>
#include <set>

#include "directories.hpp"
#include "tests/wiring/s_expression.hpp"
#include "tools/files/file_text.hpp"

namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using wiring_files::Expression;

const fs::path netlist = fs::path(PROJECT_DIRECTORY) / "boards/interface/interface.net";

// What a list of a name may hold: lists of these names, or one word.
const std::map<std::string, std::set<std::string>> grammar{
    {"export", {"version", "design", "components", "libparts", "nets"}},
    {"design", {"source", "tool"}},
    {"components", {"comp"}},
    {"comp", {"ref", "value", "footprint", "libsource", "sheetpath", "tstamps"}},
    {"libsource", {"lib", "part", "description"}},
    {"sheetpath", {"names", "tstamps"}},
    {"libparts", {"libpart"}},
    {"libpart", {"lib", "part", "pins"}},
    {"pins", {"pin"}},
    {"nets", {"net"}},
    {"net", {"code", "name", "node"}},
    {"node", {"ref", "pin", "pintype"}}};
// Lists that occur as often as they like; all others once.
const std::set<std::string> repeated{"comp", "libpart", "net", "node", "pin"};

class Reading {
 public:
  explicit Reading(const Expression& all) {
    expect_form(all, "export");
    if (all.text("version") != "E") complain("the version is not E");
    read_library(all);
    read_components(all);
    read_nets(all);
    for (const auto& [ref, part] : part_of_) {
      for (const std::string& pin : pins_of_[part]) {
        if (!connected_.contains(ref + "." + pin)) complain(ref + "." + pin + " is on no net");
      }
    }
  }

  std::vector<std::string> complaints;

 private:
  void complain(const std::string& words) { complaints.push_back(words); }

  // A pin of a library's part is a list, that of a net's node a word.
  static std::set<std::string> children_of(const std::string& name, const std::string& parent) {
    if (name == "pin" && parent == "pins") return {"num", "name", "type"};
    const auto found = grammar.find(name);
    return found == grammar.end() ? std::set<std::string>{} : found->second;
  }

  void expect_form(const Expression& one, const std::string& name, const std::string& parent = "") {
    if (one.list.empty() || one.list.front().word != name) return complain("no list " + name);
    const std::set<std::string> children = children_of(name, parent);
    if (children.empty()) {
      if (one.list.size() != 2 || !one.list[1].list.empty()) complain(name + " is not one word");
      return;
    }
    std::set<std::string> seen;
    for (auto child = one.list.begin() + 1; child != one.list.end(); ++child) {
      const std::string word = child->list.empty() ? child->word : child->list.front().word;
      if (!children.contains(word)) complain("there is no " + word + " in " + name);
      if (!seen.insert(word).second && !repeated.contains(word)) {
        complain(word + " twice in " + name);
      }
      expect_form(*child, word, name);
    }
    for (const std::string& child : children) {
      if (!seen.contains(child)) complain(name + " has no " + child);
    }
  }

  template <typename Use>
  void each(const Expression& all, const std::string& list, const std::string& name, Use use) {
    const Expression* found = all.find(list);
    if (found == nullptr) return;
    for (const Expression& one : found->list) {
      if (!one.list.empty() && one.list.front().word == name) use(one);
    }
  }

  void read_library(const Expression& all) {
    each(all, "libparts", "libpart", [&](const Expression& part) {
      std::set<std::string>& pins = pins_of_[part.text("lib") + ":" + part.text("part")];
      each(part, "pins", "pin", [&](const Expression& pin) { pins.insert(pin.text("num")); });
    });
  }

  void read_components(const Expression& all) {
    static const std::regex uuid("[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}");
    std::set<std::string> stamps;
    each(all, "components", "comp", [&](const Expression& component) {
      const std::string ref = component.text("ref"), stamp = component.text("tstamps"),
                        footprint = component.text("footprint");
      const Expression* source = component.find("libsource");
      const std::string part =
          source == nullptr ? "" : source->text("lib") + ":" + source->text("part");
      if (!part_of_.emplace(ref, part).second) complain("two components are " + ref);
      if (!pins_of_.contains(part)) complain(ref + " is of no part");
      if (component.text("value").empty()) complain(ref + " has no value");
      if (!std::regex_match(stamp, uuid)) complain(ref + " has no time stamp");
      if (!stamps.insert(stamp).second) complain(ref + " has the time stamp of another");
      // LIBRARY:NAME; none is for what stands next to the board.
      if (!footprint.empty() && !std::regex_match(footprint, std::regex(R"([^: /]+:[^: /]+)"))) {
        complain(ref + " has no footprint of a library");
      }
    });
  }

  void read_nets(const Expression& all) {
    std::set<std::string> codes, names;
    each(all, "nets", "net", [&](const Expression& net) {
      const std::string code = net.text("code"), name = net.text("name");
      if (!std::regex_match(code, std::regex("[1-9][0-9]*"))) complain(name + " has no number");
      if (!codes.insert(code).second) complain("two nets have the number " + code);
      if (!names.insert(name).second) complain("two nets are " + name);
      if (name.find_first_of(" []\t") != std::string::npos) complain("net " + name + " is a bus");
      for (const Expression& node : net.list) {
        if (node.list.empty() || node.list.front().word != "node") continue;
        const std::string ref = node.text("ref"), pin = node.text("pin");
        const auto part = part_of_.find(ref);
        if (part == part_of_.end()) {
          complain("there is no component " + ref);
        } else if (!pins_of_[part->second].contains(pin)) {
          complain(ref + " has no pin " + pin);
        }
        if (!connected_.insert(ref + "." + pin).second) {
          complain(ref + "." + pin + " is on two nets");
        }
      }
    });
  }

  std::map<std::string, std::set<std::string>> pins_of_;  // by part
  std::map<std::string, std::string> part_of_;  // by designator
  std::set<std::string> connected_;
};

TEST(KicadNetlist, is_as_kicad_reads_it) {
  EXPECT_THAT(Reading(wiring_files::read_expression(netlist)).complaints, IsEmpty());
}

void expect_found(const std::string& good, const std::string& bad, const std::string& complaint) {
  std::string text = files::text_of(netlist);
  const std::size_t place = text.find(good);
  ASSERT_NE(place, std::string::npos) << good;
  const fs::path file = fs::path(testing::TempDir()) / "stepfabric mistaken.net";
  std::ofstream(file) << text.replace(place, good.size(), bad);
  EXPECT_THAT(Reading(wiring_files::read_expression(file)).complaints,
              Contains(HasSubstr(complaint)));
  fs::remove(file);
}

TEST(KicadNetlist, with_a_mistake_is_found) {
  expect_found("(version \"E\")", "(version \"D\")", "the version is not E");
  expect_found("(ref \"R102\")", "(ref \"R101\")", "two components are R101");
  expect_found("      (value \"100 Ω\")\n", "", "comp has no value");
  expect_found("(value \"100 Ω\")", "(value \"\")", "R101 has no value");
  expect_found("\"Resistor_THT:R_Axial", "\"R_Axial", "R101 has no footprint of a library");
  expect_found("(footprint \"Resistor_THT:", "(footprnt \"Resistor_THT:", "there is no footprnt");
  expect_found("(part \"resistor\") (description", "(part \"resitor\") (description",
               "R101 is of no part");
  expect_found("(code \"2\")", "(code \"1\")", "two nets have the number 1");
  expect_found("(code \"1\")", "(code \"0\")", "has no number");
  expect_found("(name \"switch_7\")", "(name \"switch_6\")", "two nets are switch_6");
  expect_found("(name \"switch_7\")", "(name \"switch[7]\")", "net switch[7] is a bus");
  expect_found("(node (ref \"R601\") (pin \"2\")", "(node (ref \"R601\") (pin \"3\")",
               "R601 has no pin 3");
  expect_found("(node (ref \"R601\") (pin \"2\")", "(node (ref \"R601\") (pin \"1\")",
               "R601.1 is on two nets");
  expect_found("      (node (ref \"R601\") (pin \"2\") (pintype \"passive\"))\n", "",
               "R601.2 is on no net");
  expect_found("(node (ref \"R601\")", "(node (ref \"R6010\")", "there is no component R6010");
}

}  // namespace
