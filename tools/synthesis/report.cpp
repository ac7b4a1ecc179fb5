// SPDX-License-Identifier: Apache-2.0
// Reads the tools' JSON and writes one of our own, whose names stay when the tools' change.
#include "tools/synthesis/report.hpp"

#include <fmt/format.h>

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

Usage usage_of(const json& utilization, const char* kind) {
  const json& entry = utilization.at(kind);
  return {.used = entry.at("used"), .available = entry.at("available")};
}

std::string name_of(const json& end) {
  return fmt::format("{}.{}", end.at("cell").get<std::string>(), end.at("port").get<std::string>());
}

// Of the paths from register to register the one that the design's clock owns.
std::vector<Hop> slowest_path(const json& report, const std::string& clock) {
  std::vector<Hop> hops;
  for (const json& path : report.at("critical_paths")) {
    if (path.at("from") != "posedge " + clock || path.at("to") != "posedge " + clock) continue;
    for (const json& hop : path.at("path")) {
      hops.push_back({.from = name_of(hop.at("from")),
                      .to = name_of(hop.at("to")),
                      .delay_ns = hop.at("delay").get<double>()});
    }
    break;
  }
  return hops;
}

json as_object(const Usage& usage) {
  return {{"used", usage.used}, {"available", usage.available}};
}

}  // namespace

Report read_report(const std::filesystem::path& netlist, const std::filesystem::path& folder) {
  const json cells = read(netlist / "cells.json"), layout = read(folder / "report.json");
  Report report;
  try {
    report.lut4 = cells.at("design").at("num_cells_by_type").at("LUT4");
    const json& utilization = layout.at("utilization");
    report.logic_cells = usage_of(utilization, "TRELLIS_COMB");
    report.registers = usage_of(utilization, "TRELLIS_FF");
    report.block_rams = usage_of(utilization, "DP16KD");
    report.multipliers = usage_of(utilization, "MULT18X18D");
    if (layout.at("fmax").size() != 1) {
      throw std::runtime_error(
          fmt::format("there are {} clocks and not one", layout.at("fmax").size()));
    }
    const auto clock = layout.at("fmax").begin();
    report.wanted_mhz = clock.value().at("constraint");
    report.fastest_mhz = clock.value().at("achieved");
    report.critical_path = slowest_path(layout, clock.key());
  } catch (const json::exception& error) {
    throw std::runtime_error(fmt::format("{}: {}", folder.string(), error.what()));
  }
  return report;
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
  const json object = {{"board", report.board},
                       {"device", report.device},
                       {"has_debug", report.has_debug},
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
  return object.dump(2) + "\n";
}

std::string as_table(const Report& report) {
  std::string text = fmt::format("{} with an ECP5 {}{}\n", report.board, report.device,
                                 report.has_debug ? ", with its debug port" : "");
  const auto row = [&text](const char* name, const Usage& usage) {
    text += fmt::format("  {:<24}{:>7} of {:>6}{:>5} %\n", name, usage.used, usage.available,
                        100 * usage.used / usage.available);
  };
  text += fmt::format("  {:<24}{:>7}\n", "LUT4", report.lut4);
  row("logic cells", report.logic_cells);
  row("registers", report.registers);
  row("block RAM of 18 kbit", report.block_rams);
  row("multipliers 18 x 18", report.multipliers);
  text += fmt::format("  {:<24}{:>7.1f} MHz; {:.0f} MHz are wanted: {:+.0f} %\n", "fastest clock",
                      report.fastest_mhz, report.wanted_mhz, report.margin_percent());
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
  return text;
}

}  // namespace synthesis
