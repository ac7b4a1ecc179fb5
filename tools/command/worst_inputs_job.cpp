// SPDX-License-Identifier: Apache-2.0
#include "tools/command/worst_inputs_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <thread>

#include "tools/command/build.hpp"
#include "tools/command/printer_setup.hpp"
#include "tools/command/signals.hpp"
#include "tools/command/task_times.hpp"
#include "tools/worst_inputs/hard_inputs.hpp"
#include "tools/worst_inputs/search.hpp"

namespace command {

namespace {

// The same on every machine, for the same seed is to find the same.
constexpr std::uint64_t inputs_at_once = 64;

}  // namespace

WorstInputs search_worst_inputs(const timing::Program& program, const timing::Costs& costs,
                                std::uint64_t inputs, std::uint64_t seed) {
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
  worst_inputs::Rig rig(firmware, description, tasks_clock_hz);
  worst_inputs::Search search(
      seed,
      [&](const std::vector<worst_inputs::SerialInput>& some) {
        return rig.measure(some, std::thread::hardware_concurrency());
      },
      worst_inputs::hard_inputs());
  while (search.inputs() < inputs) {
    search.step(std::min<std::uint64_t>(inputs - search.inputs(), inputs_at_once));
    end_if_interrupted();
  }
  found.inputs = search.inputs();
  for (std::size_t task = 0; task < found.rows.size(); ++task) {
    const worst_inputs::Found& worst = search.worst(task);
    found.rows[task].measured = {.longest = worst.clocks, .calls = found.inputs};
    found.worst.push_back(worst_inputs::text_of(worst.input));
  }
  return found;
}

std::string to_text(const WorstInputs& found) {
  std::string text = timing::to_text(found.rows, tasks_clock_hz);
  text +=
      fmt::format("between tasks, {} clocks at most; {} inputs; the worst input of each task:\n",
                  found.between_tasks, found.inputs);
  for (std::size_t task = 0; task < found.rows.size(); ++task) {
    text += fmt::format("{}: {}\n", found.rows[task].name, found.worst[task]);
  }
  return text;
}

std::string to_json(const WorstInputs& found) {
  auto all = nlohmann::json::parse(timing::to_json(found.rows));
  for (std::size_t task = 0; task < found.rows.size(); ++task) {
    all["tasks"][task]["input"] = found.worst[task];
  }
  all["inputs"] = found.inputs;
  return all.dump(2) + "\n";
}

}  // namespace command
