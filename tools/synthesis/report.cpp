// SPDX-License-Identifier: Apache-2.0
// Reads the tools' JSON and writes a report with names of our own, which stay when the tools'
// names change.
#include "tools/synthesis/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace synthesis {
namespace {

using nlohmann::json;

json read(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  return json::parse(stream);
}

// The names and sizes of cells in each FPGA family.
struct Names {
  // Yosys' cell, and how the names of its registers begin.
  const char* lut4;
  const char* registers;
  // nextpnr's.
  const char* logic_cells;
  const char* block_rams;
  const char* multipliers;
  // For people.
  const char* block_ram;
  const char* multiplier;
};

constexpr Names names_of(Family family) {
  switch (family) {
    case Family::ecp5:
      return {"LUT4",       "TRELLIS_FF",           "TRELLIS_COMB",       "DP16KD",
              "MULT18X18D", "block RAM of 18 kbit", "multipliers 18 x 18"};
    case Family::ice40:
      return {"SB_LUT4",
              "SB_DFF",
              "ICESTORM_LC",
              "ICESTORM_RAM",
              "ICESTORM_DSP",
              "block RAM of 4 kbit",
              "multipliers 16 x 16"};
  }
  return {};
}

Usage usage_of(const json& utilization, const char* kind) {
  const json& entry = utilization.at(kind);
  return {.used = entry.at("used"), .available = entry.at("available")};
}

// The number of cells whose name has this prefix: there are many kinds of registers.
int count_of(const json& cells, const char* begin) {
  int count = 0;
  for (const auto& [name, number] : cells.items()) {
    if (name.starts_with(begin)) count += number.get<int>();
  }
  return count;
}

std::string name_of(const json& end) {
  return fmt::format("{}.{}", end.at("cell").get<std::string>(), end.at("port").get<std::string>());
}

// Of the paths from register to register the one that the design's clock owns, from and to either
// of its edges.
std::vector<Hop> slowest_path(const json& report, const std::string& clock) {
  std::vector<Hop> hops;
  const auto ends_at_clock = [&clock](const json& end) {
    return end == "posedge " + clock || end == "negedge " + clock;
  };
  for (const json& path : report.at("critical_paths")) {
    if (!ends_at_clock(path.at("from")) || !ends_at_clock(path.at("to"))) continue;
    for (const json& hop : path.at("path")) {
      hops.push_back({.from = name_of(hop.at("from")),
                      .to = name_of(hop.at("to")),
                      .delay_ns = hop.at("delay").get<double>()});
    }
    break;
  }
  return hops;
}

double wanted_of(const json& clock) { return clock.at("constraint"); }

// The longest of the paths between pins and registers, which nextpnr gives one of each direction.
double longest_ns(const json& report, bool from_pins) {
  double longest = 0;
  for (const json& path : report.at("critical_paths")) {
    const bool from = path.at("from") == "<async>", to = path.at("to") == "<async>";
    if (from != from_pins || to == from_pins) continue;
    double sum = 0;
    for (const json& hop : path.at("path")) sum += hop.at("delay").get<double>();
    longest = std::max(longest, sum);
  }
  return longest;
}

// An ECP5 has two kinds of pads with registers.
int pad_registers_of(const json& utilization) {
  int used = 0;
  for (const char* kind : {"IOLOGIC", "SIOLOGIC"}) {
    if (utilization.contains(kind)) used += utilization.at(kind).at("used").get<int>();
  }
  return used;
}

PinTimes wanted_pins_of(const json& pins) {
  return {.pad_registers = pins.at("pad_registers"),
          .input_to_register_ns = pins.at("input_to_register_ns"),
          .register_to_output_ns = pins.at("register_to_output_ns")};
}

json as_object(const PinTimes& pins) {
  return {{"pad_registers", pins.pad_registers},
          {"input_to_register_ns", pins.input_to_register_ns},
          {"register_to_output_ns", pins.register_to_output_ns}};
}

json as_object(const Usage& usage) {
  return {{"used", usage.used}, {"available", usage.available}};
}

}  // namespace

bool Report::pins_are_good() const {
  return !wanted_pins || (pins.pad_registers == wanted_pins->pad_registers &&
                          pins.input_to_register_ns <= wanted_pins->input_to_register_ns &&
                          pins.register_to_output_ns <= wanted_pins->register_to_output_ns);
}

Report read_report(const std::filesystem::path& netlist, const std::filesystem::path& folder,
                   Family family) {
  const json cells = read(netlist / "cells.json"), layout = read(folder / "report.json");
  const Names names = names_of(family);
  Report report;
  report.family = family;
  try {
    const json& kinds = cells.at("design").at("num_cells_by_type");
    report.lut4 = kinds.at(names.lut4);
    const json& utilization = layout.at("utilization");
    report.logic_cells = usage_of(utilization, names.logic_cells);
    // An iCE40 has one in each logic cell, and some devices no multiplier.
    report.registers = utilization.contains(names.registers)
                           ? usage_of(utilization, names.registers)
                           : Usage{.used = count_of(kinds, names.registers),
                                   .available = report.logic_cells.available};
    report.block_rams = usage_of(utilization, names.block_rams);
    if (utilization.contains(names.multipliers)) {
      report.multipliers = usage_of(utilization, names.multipliers);
    }
    const json& clocks = layout.at("fmax");
    if (clocks.empty()) throw std::runtime_error("there is no clock");
    // The design's clock is the one with the highest target.
    auto clock = clocks.begin();
    for (auto other = clocks.begin(); other != clocks.end(); ++other) {
      if (wanted_of(other.value()) > wanted_of(clock.value())) clock = other;
      if (other.value().at("achieved").get<double>() < wanted_of(other.value())) {
        report.slow_clocks.push_back(other.key());
      }
    }
    report.wanted_mhz = wanted_of(clock.value());
    report.fastest_mhz = clock.value().at("achieved");
    report.critical_path = slowest_path(layout, clock.key());
    report.pins = {.pad_registers = pad_registers_of(utilization),
                   .input_to_register_ns = longest_ns(layout, true),
                   .register_to_output_ns = longest_ns(layout, false)};
    if (std::filesystem::exists(folder / "pins.json")) {
      report.wanted_pins = wanted_pins_of(read(folder / "pins.json"));
    }
  } catch (const json::exception& error) {
    throw std::runtime_error(fmt::format("{}: {}", folder.string(), error.what()));
  }
  return report;
}

std::optional<std::uint32_t> memory_of(const std::filesystem::path& synthesis_json) {
  std::ifstream stream(synthesis_json);
  if (!stream) return std::nullopt;
  try {
    const json object = json::parse(stream);
    if (!object.contains("memory_bytes")) {
      return std::nullopt;  // of an earlier version
    }
    return object.at("memory_bytes").get<std::uint32_t>();
  } catch (const json::exception& error) {
    throw std::runtime_error(fmt::format("{}: {}", synthesis_json.string(), error.what()));
  }
}

std::string as_json(const Report& report) {
  json path = json::array();
  for (const Hop& hop : report.critical_path) {
    path.push_back({{"from", hop.from}, {"to", hop.to}, {"delay_ns", hop.delay_ns}});
  }
  json placements = json::array();
  for (const Placement& placement : report.placements) {
    placements.push_back({{"seed", placement.seed}, {"fastest_mhz", placement.fastest_mhz}});
  }
  json object = {{"board", report.board},
                 {"device", report.device},
                 {"family", name_of(report.family)},
                 {"has_debug", report.has_debug},
                 {"memory_bytes", report.memory_bytes},
                 {"placements", placements},
                 {"lut4", report.lut4},
                 {"logic_cells", as_object(report.logic_cells)},
                 {"registers", as_object(report.registers)},
                 {"block_rams", as_object(report.block_rams)},
                 {"multipliers", as_object(report.multipliers)},
                 {"wanted_mhz", report.wanted_mhz},
                 {"fastest_mhz", report.fastest_mhz},
                 {"margin_percent", report.margin_percent()},
                 {"critical_path", path}};
  if (report.wanted_pins) {
    object["pins"] = as_object(report.pins);
    object["wanted_pins"] = as_object(*report.wanted_pins);
  }
  return object.dump(2) + "\n";
}

std::string as_table(const Report& report) {
  const Names names = names_of(report.family);
  std::string text = fmt::format(
      "{} with an {} {}{}, {} KiB of memory\n", report.board, name_of(report.family), report.device,
      report.has_debug ? ", with its debug port" : "", report.memory_bytes / 1024);
  const auto row = [&text](const char* name, const Usage& usage) {
    if (usage.available == 0) return;
    text += fmt::format("  {:<24}{:>7} of {:>6}{:>5} %\n", name, usage.used, usage.available,
                        100 * usage.used / usage.available);
  };
  text += fmt::format("  {:<24}{:>7}\n", "LUT4", report.lut4);
  row("logic cells", report.logic_cells);
  row("registers", report.registers);
  row(names.block_ram, report.block_rams);
  row(names.multiplier, report.multipliers);
  text += fmt::format("  {:<24}{:>7.1f} MHz; {:.0f} MHz are wanted: {:+.0f} %\n", "fastest clock",
                      report.fastest_mhz, report.wanted_mhz, report.margin_percent());
  for (const std::string& clock : report.slow_clocks) {
    text += fmt::format("  too slow: clock {}\n", clock);
  }
  if (report.placements.size() > 1) {
    text += "  of the placements        ";
    for (const Placement& placement : report.placements) {
      text += fmt::format(" {:.1f} (seed {})", placement.fastest_mhz, placement.seed);
    }
    text += " MHz\n";
  }
  if (!report.critical_path.empty()) {
    text += fmt::format("  slowest path from {}\n                 to {}\n",
                        report.critical_path.front().from, report.critical_path.back().to);
  }
  if (const auto& wanted = report.wanted_pins) {
    text += fmt::format(
        "  registers in pads       {:>7}; {} are wanted\n"
        "  pin to register         {:>7.1f} ns; at most {:.1f}\n"
        "  register to pin         {:>7.1f} ns; at most {:.1f}\n",
        report.pins.pad_registers, wanted->pad_registers, report.pins.input_to_register_ns,
        wanted->input_to_register_ns, report.pins.register_to_output_ns,
        wanted->register_to_output_ns);
  }
  return text;
}

}  // namespace synthesis
