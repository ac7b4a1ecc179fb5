// SPDX-License-Identifier: Apache-2.0
// Reads the interface board's description: facts, values, kinds, boards, header.
#include "tools/wiring/description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "tools/wiring/circuit_reader.hpp"
#include "tools/wiring/toml_reader.hpp"

namespace wiring {
namespace {

std::vector<Agreement> agreements_of(const TomlReader& reader) {
  std::vector<Agreement> agreements;
  if (reader.has("machine")) {
    const TomlReader entry = reader.table("machine");
    entry.only({"entry", "scale"});
    agreements.push_back(
        {Agreement::With::machine, entry.text("entry"), "", entry.number_or("scale", 1)});
  }
  if (reader.has("signal")) {
    const TomlReader entry = reader.table("signal");
    entry.only({"port", "column", "scale"});
    agreements.push_back({Agreement::With::signal, entry.text("port"), entry.text("column"),
                          entry.number_or("scale", 1)});
  }
  if (reader.has("text")) {
    const TomlReader entry = reader.table("text");
    entry.only({"file", "says", "scale"});
    agreements.push_back({Agreement::With::text, entry.text("file"), entry.text("says"),
                          entry.number_or("scale", 1)});
  }
  return agreements;
}

Fact fact_of(const TomlReader& reader) {
  reader.only({"name", "value", "formula", "unit", "source", "machine", "signal", "text"});
  if (reader.has("value") == reader.has("formula")) reader.fail("a value or a formula is wanted");
  return {.name = reader.text("name"),
          .formula = reader.has("value") ? fmt::format("{}", reader.number("value"))
                                         : reader.text("formula"),
          .unit = reader.text("unit"),
          .source = reader.text("source"),
          .agreements = agreements_of(reader)};
}

Check check_of(const TomlReader& reader) {
  reader.only({"says", "formula", "unit", "at_most", "at_least"});
  if (reader.has("at_most") == reader.has("at_least")) reader.fail("one limit is wanted");
  const bool is_upper = reader.has("at_most");
  return {.says = reader.text("says"),
          .formula = reader.text("formula"),
          .unit = reader.text("unit"),
          .is_upper_limit = is_upper,
          .limit = reader.text(is_upper ? "at_most" : "at_least")};
}

Value value_of(const TomlReader& reader) {
  reader.only({"name", "value", "unit", "rating", "type", "why", "checks", "machine", "signal"});
  if (reader.has("value") == reader.has("type")) reader.fail("a value or a type is wanted");
  Value value;
  value.name = reader.text("name");
  if (reader.has("value")) {
    value.number = reader.number("value");
    value.unit = reader.text("unit");
  }
  value.rating = reader.text_or("rating", "");
  value.type = reader.text_or("type", "");
  value.why = reader.text("why");
  for (const TomlReader& check : reader.tables("checks")) value.checks.push_back(check_of(check));
  value.agreements = agreements_of(reader);
  return value;
}

Board board_of(const TomlReader& reader) {
  reader.only({"name", "title", "header", "column", "pattern", "printer"});
  if (reader.has("column") == reader.has("pattern")) reader.fail("a column or a pattern is wanted");
  return {reader.text("name"),           reader.text("title"),
          reader.text("header"),         reader.text_or("column", ""),
          reader.text_or("pattern", ""), reader.text_or("printer", "")};
}

toml::table parsed(const std::filesystem::path& file) {
  try {
    return toml::parse_file(file.string());
  } catch (const toml::parse_error& error) {
    throw std::runtime_error(fmt::format("{}: line {}: {}", file.filename().string(),
                                         error.source().begin.line, error.description()));
  }
}

}  // namespace

std::string Value::text() const {
  std::string words = number ? shown(*number, unit) : type;
  if (!rating.empty()) words += ", " + rating;
  return words;
}

bool is_supply(const std::string& net) { return net == "GND" || net.starts_with('+'); }

std::vector<const Part*> Description::parts() const {
  std::vector<const Part*> list{&header.part};
  for (const Circuit& circuit : circuits) {
    for (const auto& copy : circuit.parts) {
      for (const Part& part : copy) list.push_back(&part);
    }
  }
  return list;
}

Description read_description(const std::filesystem::path& project) {
  const std::filesystem::path folder = project / "boards/interface";
  const toml::table facts = parsed(folder / "facts.toml"), values = parsed(folder / "values.toml"),
                    circuits = parsed(folder / "interface.toml");
  const TomlReader fact_list(facts, "facts.toml"), value_list(values, "values.toml"),
      circuit_list(circuits, "interface.toml");
  fact_list.only({"facts"});
  value_list.only({"value"});
  circuit_list.only({"kinds", "boards", "header", "circuit"});
  Description description;
  for (const auto& fact : fact_list.tables("facts")) description.facts.push_back(fact_of(fact));
  for (const auto& value : value_list.tables("value")) {
    description.values.push_back(value_of(value));
  }
  for (const auto& board : circuit_list.tables("boards")) {
    description.boards.push_back(board_of(board));
  }
  read_circuits(circuit_list, description);
  return description;
}

Numbers numbers_of(const Description& description) {
  Numbers numbers;
  const auto add = [&numbers](const std::string& name, double value) {
    if (!numbers.emplace(name, value).second) {
      throw std::runtime_error(fmt::format("{} is said twice", name));
    }
  };
  for (const Fact& fact : description.facts) {
    add(fact.name, wiring::value_of(fact.formula, numbers));
  }
  for (const Value& value : description.values) {
    if (value.number) add(value.name, *value.number);
  }
  return numbers;
}

}  // namespace wiring
