// SPDX-License-Identifier: Apache-2.0
// Reads the file as `print` does, and shows the plan.
#include "tools/command/plan_job.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "host_link/line_number.hpp"
#include "host_link/line_receiver.hpp"
#include "machine/machine.hpp"
#include "machine_generator/description.hpp"
#include "sim/devices/gcode_file.hpp"
#include "tools/command/exit_status.hpp"
#include "tools/command/file_roles.hpp"
#include "tools/command/output.hpp"
#include "tools/command/signals.hpp"
#include "tools/files/write_file.hpp"
#include "tools/planning/path_file.hpp"
#include "tools/planning/picture.hpp"
#include "tools/planning/plan_texts.hpp"
#include "tools/planning/print_planner.hpp"

namespace command {

namespace {

machine_generator::Machine machine_of(const PlanOptions& options) {
  if (!options.machine.empty()) return machine_generator::read_machine(options.machine);
  return {.name = std::string(machine::machine.name), .description = machine::machine};
}

// A line has 128 bytes with `N`, a number of ten digits, a blank and `*255`.
constexpr std::size_t longest_command = host_link::max_line_length - 16;

void refuse_long_ones(const std::vector<devices::FileCommand>& commands, planning::Plan& plan) {
  for (const devices::FileCommand& command : commands) {
    if (command.text.size() <= longest_command) continue;
    plan.refused.push_back({.file_line = command.file_line,
                            .text = command.text,
                            .reason = "too long with a line number"});
  }
}

// Line numbers are the host's business, so an M110 of the file is not sent.
void write_commands(const std::filesystem::path& file,
                    const std::vector<devices::FileCommand>& commands) {
  std::string text;
  for (const devices::FileCommand& command : commands) {
    if (!host_link::sets_numbering(command.text)) text += command.text + '\n';
  }
  files::write_file(file, text);
}

void write_path(const PlanOptions& options, const planning::Path& path) {
  if (std::ranges::none_of(path.points, &planning::PathPoint::extrudes)) return;
  if (!options.path.empty()) files::write_file(options.path, planning::path_file_of(path));
  if (!options.picture.empty()) files::write_file(options.picture, planning::picture_of(path));
}

}  // namespace

int plan(const PlanOptions& options) {
  let_writes_fail();
  check_that_files_differ(
      std::array<NamedFile, 2>{{{"the G-code file", options.file}, {"--machine", options.machine}}},
      std::array<NamedFile, 4>{{{"--json", options.json},
                                {"--commands", options.commands},
                                {"--path", options.path},
                                {"--picture", options.picture}}});
  const machine_generator::Machine machine = machine_of(options);
  const auto commands = devices::read_gcode_file(options.file);
  if (!commands) throw std::runtime_error(commands.error());
  planning::PrintPlanner planner(machine.whole(), options.clock_hz);
  planning::PathRecorder path;
  if (!options.path.empty() || !options.picture.empty()) {
    planner.on_line([&path](const planning::Walk& walk) { path.add(walk); });
  }
  std::uint32_t number = 0;
  for (const devices::FileCommand& command : *commands) {
    end_if_interrupted();
    if (!host_link::sets_numbering(command.text)) path.begin_command(++number);
    if (!planner.take(command.file_line, command.text)) break;
    path.end_command(planner.planned_lines());
  }
  planning::Plan plan = planner.finish();
  write_path(options, path.finish(planner.steps_per_mm()));
  if (!options.commands.empty()) {
    refuse_long_ones(*commands, plan);
    write_commands(options.commands, *commands);
  }
  if (!options.json.empty()) {
    files::write_file(options.json, planning::to_json(plan, options.limits));
  }
  say("{}", planning::to_text(plan, options.limits));
  return plan.fault.empty() && plan.refused.empty() ? success : failure;
}

}  // namespace command
