// SPDX-License-Identifier: Apache-2.0
// Looks for mistakes in circuits, calculations, and against the rest of the project.
#include "tools/wiring/problems.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "tools/files/file_text.hpp"
#include "tools/files/table.hpp"
#include "tools/wiring/board_wires.hpp"
#include "tools/wiring/toml_reader.hpp"

namespace wiring {
namespace {

// Ports on the boards' headers that are not the interface board's: those of adapters.
const std::set<std::string> for_adapters{"tck", "tms", "tdi", "tdo", "motion_start"};

class Search {
 public:
  Search(const std::filesystem::path& project, const Description& description)
      : project_(project), description_(description) {}

  std::vector<std::string> run() {
    check_parts();
    check_nets();
    check_header();
    check_numbers();
    for (const Board& board : description_.boards) check_board(board);
    return found_;
  }

 private:
  void say(std::string what) { found_.push_back(std::move(what)); }

  void check_parts() {
    std::set<std::string> designators;
    for (const Part* part : description_.parts()) {
      if (!designators.insert(part->designator).second) {
        say(fmt::format("two parts are called {}", part->designator));
      }
      for (std::size_t i = 0; i < part->nets.size(); ++i) {
        pins_[part->nets[i]].push_back(
            fmt::format("{}.{}", part->designator, description_.kind_of(*part).pins[i].number));
      }
      if (part->nets.size() == 2 && part->nets[0] == part->nets[1]) {
        say(fmt::format("{} is bridged by {}", part->designator, part->nets[0]));
      }
    }
    for (const Value& value : description_.values) {
      const auto has_it = [&](const Part* part) { return &description_.value_of(*part) == &value; };
      if (std::ranges::none_of(description_.parts(), has_it)) {
        say(fmt::format("no part has the value {}", value.name));
      }
    }
  }

  void check_nets() {
    for (const auto& [net, pins] : pins_) {
      if (net.empty()) say(fmt::format("{} is not connected", pins.front()));
      if (pins.size() == 1) say(fmt::format("{} alone is connected to {}", pins.front(), net));
    }
    for (const Circuit& circuit : description_.circuits) {
      for (const Port& port : circuit.ports) {
        if (!pins_.contains(port.net)) {
          say(fmt::format("{}: no pin is connected to {}", circuit.name, port.net));
        }
      }
    }
  }

  void check_header() {
    const Header& header = description_.header;
    if (header.nets.size() != 40) say(fmt::format("the header has {} nets", header.nets.size()));
    std::map<std::string, std::size_t> places;
    for (std::size_t i = 0; i < header.nets.size(); ++i) {
      const std::string& net = header.nets[i];
      const auto position = i + 1;
      const bool is_open = std::ranges::count(header.unconnected, static_cast<int>(position)) != 0;
      if (net.empty() != is_open) {
        say(fmt::format("header position {}: a net, or unconnected", position));
      }
      if (net.empty() || is_supply(net)) continue;
      if (!places.emplace(net, position).second) {
        say(fmt::format("{} is at header positions {} and {}", net, places[net], position));
      }
    }
  }

  void check_numbers() {
    Numbers numbers;
    try {
      numbers = numbers_of(description_);
    } catch (const std::runtime_error& error) {
      return say(error.what());
    }
    for (const Fact& fact : description_.facts) {
      check_agreements(fact.name, numbers.at(fact.name), fact.agreements);
    }
    for (const Value& value : description_.values) {
      if (value.number) check_agreements(value.name, *value.number, value.agreements);
      for (const Check& check : value.checks) check_limit(value.name, check, numbers);
      // A part without a number is what it is.
      if (value.number && value.checks.empty()) say(value.name + " has no calculation");
    }
  }

  void check_limit(const std::string& name, const Check& check, const Numbers& numbers) {
    try {
      const double result = value_of(check.formula, numbers),
                   limit = value_of(check.limit, numbers);
      if (check.is_upper_limit ? result <= limit : result >= limit) return;
      say(fmt::format("{}: {} is {}, must be at {} {}", name, check.says, shown(result, check.unit),
                      check.is_upper_limit ? "most" : "least", shown(limit, check.unit)));
    } catch (const std::runtime_error& error) {
      say(fmt::format("{}: {}", name, error.what()));
    }
  }

  void check_agreements(const std::string& name, double number,
                        const std::vector<Agreement>& agreements) {
    for (const Agreement& agreement : agreements) {
      try {
        if (agreement.with == Agreement::With::text) {
          check_text(agreement, number);
          continue;
        }
        const double other = agreement.scale * number_there(agreement);
        if (std::abs(number - other) > 1e-9 * std::abs(other)) {
          say(fmt::format("{} is {:g} here, {:g} in {}", name, number, other, agreement.place));
        }
      } catch (const std::exception& error) {
        say(fmt::format("{}: {}: {}", name, agreement.place, error.what()));
      }
    }
  }

  // The file says the text, with the number in the place of #.
  void check_text(const Agreement& agreement, double number) const {
    std::string text = agreement.what;
    if (const std::size_t place = text.find('#'); place != std::string::npos) {
      text.replace(place, 1, fmt::format("{:g}", number / agreement.scale));
    }
    if (files::text_of(project_ / agreement.place).find(text) == std::string::npos) {
      throw std::runtime_error(fmt::format("it does not say \"{}\"", text));
    }
  }

  double number_there(const Agreement& agreement) {
    switch (agreement.with) {
      case Agreement::With::machine: {
        const auto machine =
            toml::parse_file((project_ / "firmware/machines/prusa_mendel.toml").string());
        const auto value = machine.at_path(agreement.place).value<double>();
        if (!value) throw std::runtime_error("no such entry");
        return *value;
      }
      case Agreement::With::signal: {
        const auto signals = files::read_table(project_ / "constraints/signals.csv");
        const files::Row* row = files::row_with(signals, "port", agreement.place);
        if (row == nullptr) throw std::runtime_error("no such port");
        return std::stod(row->at(agreement.what));
      }
      case Agreement::With::text:
        break;
    }
    return 0;
  }

  // Each pin that the printer had still leads to the header, at the same position.
  void check_printer(const Board& board) {
    try {
      const std::vector<Wire> wires = wires_of(project_, board);
      for (const files::Row& row : files::read_table(project_ / "boards" / board.printer)) {
        if (row.at("header_pin").empty()) continue;
        const auto wire = std::ranges::find(wires, row.at("pin"), &Wire::fpga_pin);
        if (wire == wires.end()) {
          say(fmt::format("{}: nothing leads to {} of the printer, position {}", board.name,
                          row.at("signal"), row.at("header_pin")));
        } else if (fmt::format("{}", wire->position) != row.at("header_pin")) {
          say(fmt::format("{}: {} is at position {}, where the printer has {} at {}", board.name,
                          wire->port, wire->position, row.at("signal"), row.at("header_pin")));
        }
      }
    } catch (const std::exception& error) {
      say(error.what());
    }
  }

  void check_board(const Board& board) {
    if (!board.printer.empty()) return check_printer(board);
    std::set<std::string> connected;
    const auto& nets = description_.header.nets;
    try {
      for (const Wire& wire : wires_of(project_, board)) {
        if (for_adapters.contains(wire.port.substr(0, wire.port.find('[')))) continue;
        if (wire.position == 0 && !wire.is_on_cable) continue;
        connected.insert(wire.port);
        const bool is_there = std::ranges::count(nets, wire.port) != 0;
        if (!is_there) {
          say(fmt::format("{}: {} is not on the interface board", board.name, wire.port));
        } else if (wire.position != 0 &&
                   nets.at(static_cast<std::size_t>(wire.position) - 1) != wire.port) {
          say(fmt::format("{}: {} is at position {}, where the interface board has {}", board.name,
                          wire.port, wire.position,
                          nets.at(static_cast<std::size_t>(wire.position) - 1)));
        }
      }
    } catch (const std::exception& error) {
      return say(error.what());
    }
    for (const std::string& net : nets) {
      if (!net.empty() && !is_supply(net) && !connected.contains(net)) {
        say(fmt::format("{}: {} does not come from the board", board.name, net));
      }
    }
  }

  const std::filesystem::path& project_;
  const Description& description_;
  std::map<std::string, std::vector<std::string>> pins_;
  std::vector<std::string> found_;
};

}  // namespace

std::vector<std::string> problems_of(const std::filesystem::path& project,
                                     const Description& description) {
  return Search(project, description).run();
}

}  // namespace wiring
