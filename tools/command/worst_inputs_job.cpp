// SPDX-License-Identifier: Apache-2.0
#include "tools/command/worst_inputs_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <thread>

#include "tools/command/build.hpp"
#include "tools/command/printer_setup.hpp"
#include "tools/command/progress.hpp"
#include "tools/command/search_state_file.hpp"
#include "tools/command/signals.hpp"
#include "tools/command/task_times.hpp"
#include "tools/worst_inputs/hard_inputs.hpp"
#include "tools/worst_inputs/search.hpp"
#include "tools/worst_inputs/starts.hpp"

namespace command {

namespace {

// Eight for each start where that makes no small ones. The same on every machine, for the same seed
// is to find the same.
std::uint64_t inputs_of_a_generation(std::uint64_t inputs, std::uint64_t starts) {
  constexpr std::uint64_t generations = 8, least = 32, most = 512;
  return std::clamp(inputs / (generations * starts), least, most);
}

constexpr std::array functions{"gcode::parse", "motion::Planner::append"};

// What is looked at clock by clock.
struct Watched {
  worst_inputs::SerialInput start, input;
};

bool holds(const timing::TaskRow& row, timing::Clocks between_tasks, timing::Clocks longest) {
  return row.bound && longest <= *row.bound + between_tasks;
}

void measure_functions(WorstInputs& found, worst_inputs::Rig& rig, const timing::Program& program,
                       timing::Analysis& analysis, const std::vector<Watched>& inputs) {
  std::vector<timing::Address> addresses;
  for (const char* name : functions) {
    for (const timing::Address address : program.find(name)) {
      addresses.push_back(address);
      found.functions.push_back({.name = name, .bound = analysis.bound(address), .longest = 0});
    }
  }
  for (const auto& [start, input] : inputs) {
    const auto longest = rig.longest_calls(start, input, program, CHIP_HAS_ZBB, addresses);
    for (std::size_t i = 0; i < longest.size(); ++i) {
      found.functions[i].longest = std::max(found.functions[i].longest, longest[i]);
    }
  }
}

}  // namespace

WorstInputs search_worst_inputs(const timing::Program& program, const timing::Costs& costs,
                                const WorstInputSearch& wanted) {
  timing::Analysis analysis(program, costs, CHIP_HAS_ZBB);
  WorstInputs found;
  found.rows = timing::task_rows(program, analysis);
  const timing::Load load = timing::load_of(program, analysis, found.rows);
  found.between_tasks = load.start.value_or(0);
  for (const auto& gap : load.gaps) {
    found.between_tasks = std::max(found.between_tasks, gap.value_or(0));
  }
  // The pass is the last one, as in what is measured.
  std::ranges::rotate(found.rows, found.rows.begin() + 1);
  const sim::ElfImage firmware = sim::read_elf(build_folder() / "firmware" / "firmware.elf");
  const machine::Description description = description_of({});
  worst_inputs::Rig rig(firmware, description, tasks_clock_hz,
                        found.rows.back().bound.value_or(0) + found.between_tasks);
  const std::vector<worst_inputs::Start> starts = worst_inputs::starts();
  const std::vector<worst_inputs::SerialInput> first = worst_inputs::hard_inputs();
  // Results are collected in order: one that takes long keeps no processor from the next ones.
  const unsigned at_once = 4 * std::max(std::thread::hardware_concurrency(), 1U);
  worst_inputs::Search search(
      wanted.seed, starts.size(),
      [&](std::size_t start, const std::vector<worst_inputs::SerialInput>& some) {
        return rig.measure(starts[start].input, some, at_once);
      },
      first);
  const auto all_hold = [&] {
    for (std::size_t task = 0; task < found.rows.size(); ++task) {
      if (!holds(found.rows[task], found.between_tasks, search.worst(task).clocks)) return false;
    }
    return true;
  };
  const SearchStateFile state(wanted.state, firmware, wanted.seed);
  if (state.is_there()) state.resume(search);
  const std::uint64_t generation = inputs_of_a_generation(wanted.inputs, starts.size());
  Progress progress;
  while (search.inputs() == 0 ||
         (search.inputs() < wanted.inputs && all_hold() && !interrupt_requested())) {
    search.step(std::min(wanted.inputs - search.inputs(), generation));
    if (progress.due()) {
      state.write(search);
      progress.show_text(fmt::format("{} of {} inputs; the longest pass {} clocks", search.inputs(),
                                     wanted.inputs, search.worst(worst_inputs::pass_place).clocks));
    }
  }
  progress.finish();
  state.write(search);
  found.inputs = search.inputs();
  std::vector<Watched> watched;
  for (const auto& input : first) watched.push_back({starts.front().input, input});
  for (const auto& start : starts) watched.push_back({starts.front().input, start.input});
  for (std::size_t task = 0; task < found.rows.size(); ++task) {
    const worst_inputs::Found& worst = search.worst(task);
    const worst_inputs::Start& start = starts[worst.start];
    found.rows[task].measured = {.longest = worst.clocks, .calls = found.inputs};
    found.worst.push_back({start.name, worst_inputs::text_of(worst.input)});
    watched.push_back({start.input, worst.input});
  }
  measure_functions(found, rig, program, analysis, watched);
  return found;
}

bool holds(const WorstInputs& found) {
  const auto task_holds = [&](const timing::TaskRow& row) {
    return holds(row, found.between_tasks, row.measured.longest);
  };
  const auto function_holds = [](const WorstInputs::Function& function) {
    return function.bound && function.longest <= *function.bound;
  };
  return std::ranges::all_of(found.rows, task_holds) &&
         found.functions.size() >= functions.size() &&
         std::ranges::all_of(found.functions, function_holds);
}

std::string to_text(const WorstInputs& found) {
  std::string text = timing::to_text(found.rows, tasks_clock_hz);
  for (const auto& [name, bound, longest] : found.functions) {
    const auto clocks = static_cast<double>(bound.value_or(0));
    const double ratio = clocks / static_cast<double>(std::max<timing::Clocks>(longest, 1));
    text += fmt::format("{:<45}{:>14}{:>16}{:>20.1f}\n", name,
                        bound ? std::to_string(*bound) : "none", longest, ratio);
  }
  text +=
      fmt::format("between tasks, {} clocks at most; {} inputs; the worst input of each task:\n",
                  found.between_tasks, found.inputs);
  for (std::size_t task = 0; task < found.rows.size(); ++task) {
    text += fmt::format("{}: [{}] {}\n", found.rows[task].name, found.worst[task].start,
                        found.worst[task].input);
  }
  return text;
}

std::string to_json(const WorstInputs& found) {
  auto all = nlohmann::json::parse(timing::to_json(found.rows));
  for (std::size_t task = 0; task < found.rows.size(); ++task) {
    all["tasks"][task]["start"] = found.worst[task].start;
    all["tasks"][task]["input"] = found.worst[task].input;
  }
  for (const auto& [name, bound, longest] : found.functions) {
    all["functions"].push_back({{"name", name},
                                {"bound", bound ? nlohmann::json(*bound) : nlohmann::json(nullptr)},
                                {"longest", longest}});
  }
  all["inputs"] = found.inputs;
  return all.dump(2) + "\n";
}

}  // namespace command
