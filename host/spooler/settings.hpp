// SPDX-License-Identifier: Apache-2.0
// Where a spooler keeps its data, and which programs it starts.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "host/spooler/printer_spec.hpp"

namespace spooler {

struct Settings {
  std::filesystem::path data;  // folder
  std::vector<PrinterSpec> printers;
  std::filesystem::path feeder_program;
  // The program with the jobs `plan` and `serve`.
  std::filesystem::path tool_program;
  std::uint32_t baud = 250'000;
  // So long after a person has said that a bed is clear nothing starts there; 0: no limit.
  std::chrono::milliseconds bed_clear_limit{0};
  std::chrono::minutes pause_limit{0};  // then a paused job's hotend is switched off; 0: never
  std::string simulation_speed = "real";  // or max
  std::chrono::milliseconds check_interval{20'000};  // until a check that failed is tried again
  std::string database{};  // address of a PostgreSQL server's; empty: queue.db in `data`
  std::string place{};  // of this spooler, for people at others on the same database
  std::chrono::milliseconds lease_time{15'000};  // of each printer, on such a database
};

}  // namespace spooler
