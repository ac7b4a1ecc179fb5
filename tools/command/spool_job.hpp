// SPDX-License-Identifier: Apache-2.0
// `spool`: the connected printer: jobs come over HTTP, wait in a durable queue, and are printed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace command {

struct SpoolOptions {
  std::filesystem::path data;  // empty: spool in $XDG_DATA_HOME/stepfabric
  std::string listen = "127.0.0.1:5080";
  std::vector<std::string> printers{"simulated"};
  std::string database;  // PostgreSQL's address; empty: a file in `data`
  std::filesystem::path key;  // file; empty: no key is needed
  std::vector<std::string> host_names;
  bool builds = true;  // what the spooler starts
  bool allows_root = false;  // also where other machines reach it
  std::string moonraker;  // address of the first printer's; empty: none
  std::filesystem::path frontend;
  std::vector<std::string> webhooks;  // URL, or @FILE with one
  std::string mqtt;  // address of the broker; empty: none
  std::filesystem::path mqtt_login;  // file with user and password; empty: none
  std::string mqtt_topic = "stepfabric";
  std::uint32_t baud = 250'000;
  std::int64_t bed_clear_limit_h = 24;  // so long a clear bed counts as such; 0: no limit
  std::int64_t pause_limit_min = 30;  // then a paused job's hotend is switched off; 0: never
  std::string simulation_speed = "real";
};

// Adds the job to the program.
void add_options(CLI::App& app, SpoolOptions& options);

// Runs until interrupted. Returns the exit status of the job.
int spool(const SpoolOptions& options);

}  // namespace command
