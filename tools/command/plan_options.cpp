// SPDX-License-Identifier: Apache-2.0
// The options of the job `plan`, and what its help says.
#include "tools/command/plan_job.hpp"
#include "tools/command/printer_options.hpp"

namespace command {

void add_options(CLI::App& app, PlanOptions& options) {
  CLI::App& job = *app.add_subcommand(
      "plan", "Calculate time, steps and peaks of a print by the firmware's planner.");
  job.add_option("file", options.file, "the G-code file")->required()->type_name("FILE.gcode");
  job.add_option("--machine", options.machine,
                 "description of the machine (TOML); default: that of the build")
      ->type_name("FILE.toml");
  job.add_option("--json", options.json, "write the plan into this file")->type_name("FILE.json");
  job.add_option("--commands", options.commands,
                 "write what a host sends, one command a line, without comments and M110")
      ->type_name("FILE");
  job.add_option("--most-refused", options.limits.refused,
                 "list at most so many refused lines; default: all")
      ->type_name("N");
  job.add_option("--most-layers", options.limits.layers,
                 "list at most so many layers; default: all")
      ->type_name("N");
  job.add_option(
         "--path", options.path,
         "write the path by layers (tools/planning/path_file.hpp), if something is extruded")
      ->type_name("FILE");
  job.add_option("--picture", options.picture,
                 "write a small picture of the path, if something is extruded")
      ->type_name("FILE.png");
  job.add_option("--clock-hz", options.clock_hz, "clock of the chip")
      ->check(CLI::Range(lowest_clock_hz, highest_clock_hz))
      ->capture_default_str();
  job.footer(
      R"(The firmware executes the file without the chip: heaters are at their targets at once, and
lines come as fast as they are taken.

Exit status: 0 every line was taken, 1 lines were refused or the print ends early, 2 bad usage or
not such a file.)");
}

}  // namespace command
