// SPDX-License-Identifier: Apache-2.0
// Runs each work, and computes on this machine what it must have computed.
#include "tools/benchmark/processor_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "benchmark/core_work.hpp"
#include "benchmark/parser_work.hpp"
#include "benchmark/planner_work.hpp"
#include "benchmark/record_work.hpp"

namespace benchmarks {

namespace {

using benchmark::ProcessorResult;

template <class Work>
ProcessorResult on_this_machine(std::uint32_t iterations, const std::string& text) {
  const auto work = std::make_unique<Work>();
  work->prepare(text);
  return work->run(iterations);
}

struct Work {
  const char* name;
  std::string_view program;
  const char* unit;
  const char* file;
  std::uint32_t iterations;
  ProcessorResult (*expected)(std::uint32_t iterations, const std::string& text);
};

constexpr const char* washer = "washer.gcode";
constexpr const char* cube = "cube20_02_marlin.gcode";

constexpr std::array works{
    Work{"core", "core", "iteration", "", 10, on_this_machine<benchmark::CoreWork>},
    Work{"records", "record", "iteration", "", 4000, on_this_machine<benchmark::RecordWork>},
    Work{"parser, washer", "parser", "line", washer, 4, on_this_machine<benchmark::ParserWork>},
    Work{"parser, cube", "parser", "line", cube, 4, on_this_machine<benchmark::ParserWork>},
    Work{"planner, washer", "planner", "move", washer, 2, on_this_machine<benchmark::PlannerWork>},
    Work{"planner, cube", "planner", "move", cube, 2, on_this_machine<benchmark::PlannerWork>}};

constexpr const char* uncompressed_suffix = "_without_c";
constexpr const char* zbb_suffix = "_with_zbb";

CompiledWork run_compiled(const Work& work, const char* suffix, std::uint32_t iterations,
                          const std::string& text, const ProcessorScope& scope) {
  const std::string name = fmt::format("{}_benchmark{}.elf", work.program, suffix);
  const auto program = sim::read_elf(scope.programs / name);
  CompiledWork compiled{.run = run_work(program, iterations, text),
                        .code_bytes = program.sizes.text_bytes};
  const ProcessorResult expected = work.expected(iterations, text);
  const ProcessorResult& result = compiled.run.result;
  if (result.units != expected.units || result.checksum != expected.checksum) {
    throw std::runtime_error(fmt::format(
        "{} ({}) computed {:#x} of {} units; the same code on this machine {:#x} of {}", work.name,
        name, result.checksum, result.units, expected.checksum, expected.units));
  }
  return compiled;
}

void check_names(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (std::ranges::find(works, name, &Work::program) == works.end()) {
      throw std::runtime_error(
          fmt::format("there is no work {}: name core, record, parser or planner", name));
    }
  }
}

bool is_wanted(const Work& work, const std::vector<std::string>& names) {
  return names.empty() || std::ranges::find(names, work.program) != names.end();
}

}  // namespace

std::string moves_of(const std::filesystem::path& file, std::size_t most_bytes) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  stream.seekg(static_cast<std::streamoff>(std::filesystem::file_size(file) / 3));
  std::string text;
  std::string line;
  std::getline(stream, line);  // the rest of one
  while (std::getline(stream, line)) {
    if (!line.starts_with("G1 ") && !line.starts_with("G0 ")) continue;
    line.erase(std::min(line.find(';'), line.size()));
    while (line.ends_with(' ') || line.ends_with('\r')) line.pop_back();
    if (text.size() + line.size() + 1 > most_bytes) break;
    text += line + "\n";
  }
  return text;
}

ProcessorFigures measure_processor(const ProcessorScope& scope,
                                   const std::function<void(const std::string&)>& say) {
  ProcessorFigures figures;
  check_names(scope.works);
  for (const Work& work : works) {
    if (!is_wanted(work, scope.works)) continue;
    say(work.name);
    const std::string file = work.file;
    const std::string text =
        file.empty() ? file
                     : moves_of(scope.examples / file, benchmark::ProcessorOrder::most_text_bytes);
    const std::uint32_t iterations = scope.quick ? 1 : work.iterations;
    figures.works.push_back(
        {.name = work.name,
         .unit = work.unit,
         .file = file,
         .iterations = iterations,
         .compressed = run_compiled(work, "", iterations, text, scope),
         .uncompressed = run_compiled(work, uncompressed_suffix, iterations, text, scope),
         .with_zbb = run_compiled(work, zbb_suffix, iterations, text, scope)});
  }
  const auto size_of = [&](const char* suffix) {
    return sim::read_elf(scope.programs / fmt::format("firmware_alone{}.elf", suffix))
        .sizes.text_bytes;
  };
  figures.firmware_bytes = size_of("");
  figures.firmware_bytes_uncompressed = size_of(uncompressed_suffix);
  figures.firmware_bytes_with_zbb = size_of(zbb_suffix);
  return figures;
}

}  // namespace benchmarks
