// SPDX-License-Identifier: Apache-2.0
// JSON, table and page.
#include "tools/benchmark/processor_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

namespace benchmarks {

namespace {

using Json = nlohmann::ordered_json;

double rounded(double value) { return std::round(value * 1e4) / 1e4; }

double per_hundred(const ClockUse& use, std::uint64_t count) {
  return 100.0 * static_cast<double>(count) / static_cast<double>(use.instructions());
}

Json compiled_json(const CompiledWork& work) {
  const ClockUse& use = work.run.use;
  const double clocks = static_cast<double>(use.clocks());
  return {{"code_bytes", work.code_bytes},
          {"clocks", use.clocks()},
          {"instructions", use.instructions()},
          {"clocks_per_instruction", rounded(clocks / static_cast<double>(use.instructions()))}};
}

Json work_json(const WorkFigure& work) {
  const ClockUse& use = work.compressed.run.use;
  Json json{{"name", work.name}};
  if (!work.file.empty()) json["file"] = work.file;
  json["unit"] = work.unit;
  json["units"] = work.compressed.run.result.units;
  json["checksum"] = work.compressed.run.result.checksum;
  json["clocks_per_unit"] = rounded(work.clocks_per_unit());
  json["units_per_second_per_mhz"] = rounded(1e6 / work.clocks_per_unit());
  json["rv32imc"] = compiled_json(work.compressed);
  json["rv32im"] = compiled_json(work.uncompressed);
  json["rv32imc_zbb"] = compiled_json(work.with_zbb);
  for (std::size_t i = 0; i < waiting_kinds; ++i) {
    json["waiting_clocks"][waiting_names[i]] = use.waited(static_cast<Waiting>(i));
  }
  for (std::size_t i = 0; i < event_kinds; ++i) {
    json["events"][event_names[i]] = use.count(static_cast<Event>(i));
  }
  return json;
}

}  // namespace

std::string to_json(const ProcessorFigures& figures) {
  Json json{{"benchmark", "processor"}};
  for (const WorkFigure& work : figures.works) json["works"].push_back(work_json(work));
  json["firmware"] = {{"rv32imc_code_bytes", figures.firmware_bytes},
                      {"rv32im_code_bytes", figures.firmware_bytes_uncompressed},
                      {"rv32imc_zbb_code_bytes", figures.firmware_bytes_with_zbb}};
  return json.dump(2) + "\n";
}

std::string to_table(const ProcessorFigures& figures) {
  fmt::memory_buffer out;
  const auto add = [&]<class... Arguments>(fmt::format_string<Arguments...> format,
                                           Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(out), format, std::forward<Arguments>(arguments)...);
  };
  add("{:<16} {:>10} {:>12} {:>7} {:>12} {:>10}  {:>8} {:>8} {:>7} {:>9} {:>12} {:>7}\n", "",
      "clocks", "instructions", "clocks", "clocks", "units/s", "code", "without", "clocks",
      "with Zbb:", "clocks", "clocks");
  add("{:<16} {:>10} {:>12} {:>7} {:>12} {:>10}  {:>8} {:>8} {:>7} {:>9} {:>12} {:>7}\n", "", "",
      "", "each", "per unit", "per MHz", "bytes", "C", "each", "bytes", "per unit", "each");
  for (const WorkFigure& work : figures.works) {
    const ClockUse& use = work.compressed.run.use;
    const auto clocks_each = [](const CompiledWork& compiled) {
      return double(compiled.run.use.clocks()) / double(compiled.run.use.instructions());
    };
    add("{:<16} {:>10} {:>12} {:>7.3f} {:>12.1f} {:>10.2f}  {:>8} {:>8} {:>7.3f} {:>9} {:>12.1f} "
        "{:>7.3f}\n",
        work.name, use.clocks(), use.instructions(), work.clocks_per_instruction(),
        work.clocks_per_unit(), 1e6 / work.clocks_per_unit(), work.compressed.code_bytes,
        work.uncompressed.code_bytes, clocks_each(work.uncompressed), work.with_zbb.code_bytes,
        work.clocks_per_unit_with_zbb(), clocks_each(work.with_zbb));
  }
  add("{:<16} {:>64} {:>8} {:>17}\n", "firmware", figures.firmware_bytes,
      figures.firmware_bytes_uncompressed, figures.firmware_bytes_with_zbb);
  add("\nclocks of 100 instructions beyond 100:\n{:<16}", "");
  for (const char* name : waiting_names) add(" {:>12}", name);
  add("\n");
  for (const WorkFigure& work : figures.works) {
    const ClockUse& use = work.compressed.run.use;
    add("{:<16}", work.name);
    for (std::size_t i = 0; i < waiting_kinds; ++i) {
      add(" {:>12.2f}", per_hundred(use, use.waited(static_cast<Waiting>(i))));
    }
    add("\n");
  }
  add("\nof 100 instructions:\n");
  for (std::size_t i = 0; i < event_kinds; ++i) {
    add("{:<26}", event_names[i]);
    for (const WorkFigure& work : figures.works) {
      const ClockUse& use = work.compressed.run.use;
      add(" {:>7.2f}", per_hundred(use, use.count(static_cast<Event>(i))));
    }
    add("\n");
  }
  return fmt::to_string(out);
}

std::string to_html(const ProcessorFigures& figures) {
  return fmt::format(
      "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>Processor</title>\n"
      "<style>body{{font:15px/1.5 Lato,\"DejaVu Sans\",sans-serif;color:#2b323a;max-width:1180px;"
      "margin:24px auto;padding:0 20px}}pre{{background:#f3f5f7;padding:14px;overflow-x:auto}}"
      "</style>\n<h1>The processor at work</h1>\n<p>Core and records are works of this project's "
      "own making; parser and planner are the firmware's code on lines of sliced files.</p>\n"
      "<pre>{}</pre></html>\n",
      to_table(figures));
}

}  // namespace benchmarks
