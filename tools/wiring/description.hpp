// SPDX-License-Identifier: Apache-2.0
// The interface board as boards/interface/*.toml describe it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/wiring/formula.hpp"

namespace wiring {

// Another place of the project that must say the same as a number here.
struct Agreement {
  enum class With { machine, signal, text };
  With with{};
  // Entry of the machine description, port of constraints/signals.csv, or a file.
  std::string place;
  // Column of the port, or what the file says, with # for the number.
  std::string what;
  // The number here is so many times the one there.
  double scale = 1;
};

// What calculations start from.
struct Fact {
  std::string name;
  std::string formula;  // or a number
  std::string unit;
  std::string source;
  std::vector<Agreement> agreements;
};

// A calculation that a value must pass.
struct Check {
  std::string says;
  std::string formula;
  std::string unit;
  bool is_upper_limit{};
  std::string limit;  // a formula too
};

// Of parts: a number with its unit, or a type.
struct Value {
  std::string name;
  std::optional<double> number;
  std::string unit;
  std::string rating;
  std::string type;
  std::string why;
  std::vector<Check> checks;
  std::vector<Agreement> agreements;

  std::string text() const;
};

struct Pin {
  std::string number;
  std::string name;  // as the number, where it has none
};

struct Kind {
  std::string name;
  std::string prefix;  // of designators
  std::string symbol;
  std::string footprint;  // empty: not on the board
  std::vector<Pin> pins;
  std::vector<std::string> left, right;  // numbers of the pins of a symbol `box`, from above
};

struct Place {
  double x{};
  double y{};
};

struct Part {
  std::string designator;
  std::size_t kind{};
  std::size_t value{};
  std::vector<std::string> nets;  // of the kind's pins
  Place at;
  bool is_turned{};
  bool is_mirrored{};
};

struct Port {
  std::string net;
  Place at;
};

struct Circuit {
  std::string name;
  std::string title;
  std::string about;
  std::vector<std::string> copies;
  Place size;
  std::vector<Port> ports;  // of the first copy
  std::vector<std::vector<Part>> parts;  // by copy
};

struct Header {
  Part part;
  std::vector<std::string> nets;  // by position, from 1; empty: unconnected
  std::vector<int> unconnected;
};

struct Board {
  std::string name;
  std::string title;
  std::string header;
  std::string column;  // of boards/header40.csv
  std::string pattern;  // or of the signals that a cable of single wires begins at
  // Table of pins in boards, of a printer that has no interface board; else empty.
  std::string printer;
};

struct Description {
  std::vector<Fact> facts;
  std::vector<Value> values;
  std::vector<Kind> kinds;
  std::vector<Board> boards;
  Header header;
  std::vector<Circuit> circuits;

  // The header and all copies of all circuits.
  std::vector<const Part*> parts() const;
  const Kind& kind_of(const Part& part) const { return kinds[part.kind]; }
  const Value& value_of(const Part& part) const { return values[part.value]; }
};

// Out of the project's boards/interface. Throws std::runtime_error, with the file and the place in
// it, where something is missing, unknown or said twice.
Description read_description(const std::filesystem::path& project);

// All numbers by name, facts first. Throws std::runtime_error.
Numbers numbers_of(const Description& description);

// A net of supply, which stands for itself in a picture.
bool is_supply(const std::string& net);

}  // namespace wiring
