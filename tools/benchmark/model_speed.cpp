// SPDX-License-Identifier: Apache-2.0
// Times runs of the chip's model in processor time of this process.
#include "tools/benchmark/model_speed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace benchmarks {

namespace {

constexpr int runs = 3;

ModelWork measure_work(const NamedRun& work_of, const ModelScope& scope) {
  ModelWork work{.name = work_of.name, .clock_hz = work_of.clock_hz};
  for (int i = 0; i < (scope.quick ? 1 : runs); ++i) {
    for (const ModelKind kind :
         {ModelKind::usual, ModelKind::whole_netlist, ModelKind::resting, ModelKind::all_edges}) {
      // Many times more clocks would take minutes.
      if (work.clock_hz != model_clock_hz && kind == ModelKind::all_edges) continue;
      const Measured measured = work_of.run(scope, {.kind = kind, .clock_hz = work.clock_hz});
      const auto clocks = static_cast<double>(measured.clocks);
      double& best = work.clocks_per_second[static_cast<std::size_t>(kind)];
      best = std::max(best, clocks / std::max(measured.seconds, 1e-6));
      work.clocks = measured.clocks;
      work.awake = 1 - static_cast<double>(measured.processor.sleeping_clocks) / clocks;
      work.instructions_per_clock = static_cast<double>(measured.processor.instructions) / clocks;
    }
  }
  return work;
}

}  // namespace

std::vector<ModelWork> measure_model(const ModelScope& scope,
                                     const std::function<void(const std::string&)>& say) {
  std::vector<ModelWork> works;
  for (const NamedRun& work : model_works) {
    say(fmt::format("the model, {}", work.name));
    works.push_back(measure_work(work, scope));
  }
  return works;
}

std::string to_json(const std::vector<ModelWork>& works) {
  nlohmann::ordered_json json{{"benchmark", "model"}};
  for (const ModelWork& work : works) {
    json["works"].push_back(
        {{"name", work.name},
         {"clock_hz", work.clock_hz},
         {"clocks", work.clocks},
         {"awake", work.awake},
         {"instructions_per_clock", work.instructions_per_clock},
         {"clocks_per_second", work.speed(ModelKind::usual)},
         {"simulated_seconds_per_second", work.pace()},
         {"clocks_per_second_processor_by_netlist", work.speed(ModelKind::whole_netlist)},
         {"clocks_per_second_without_leaps", work.speed(ModelKind::resting)},
         {"clocks_per_second_all_edges", work.speed(ModelKind::all_edges)}});
  }
  return json.dump(2) + "\n";
}

std::string to_table(const std::vector<ModelWork>& works) {
  std::string table =
      fmt::format("{:<20} {:>7} {:>13} {:>10} {:>13} {:>10} {:>10} {:>10}\n", "", "awake",
                  "instructions", "million", "processor", "without", "all edges", "simulated");
  table += fmt::format("{:<20} {:>7} {:>13} {:>10} {:>13} {:>10} {:>10} {:>10}\n", "", "",
                       "per clock", "clocks/s", "by netlist", "leaps", "", "s per s");
  for (const ModelWork& work : works) {
    const double speed = work.speed(ModelKind::usual);
    table += fmt::format(
        "{:<20} {:>6.1f}% {:>13.3f} {:>10.2f} {:>13.2f} {:>10.2f} {:>10.2f} {:>10.2f}\n", work.name,
        100 * work.awake, work.instructions_per_clock, speed * 1e-6,
        work.speed(ModelKind::whole_netlist) * 1e-6, work.speed(ModelKind::resting) * 1e-6,
        work.speed(ModelKind::all_edges) * 1e-6, work.pace());
  }
  for (const ModelWork& work : works) {
    if (work.name.starts_with("serving")) {
      table += fmt::format("{}: serve --speed real {} on a core of its own\n", work.name,
                           work.pace() >= 1 ? "keeps up" : "does not keep up");
    }
  }
  return table;
}

}  // namespace benchmarks
