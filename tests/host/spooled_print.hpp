// SPDX-License-Identifier: Apache-2.0
// `stepfabric spool` as a user starts it, with co-simulated chips, and curl as a slicer.
#pragma once

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "directories.hpp"
#include "tools/process/process.hpp"

namespace host_test {

namespace fs = std::filesystem;
using json = nlohmann::json;
using Clock = std::chrono::steady_clock;
inline const std::string stepfabric = BUILD_DIRECTORY "/bin/stepfabric";

// Moves to and fro in lines of some millimetres.
std::string job(int moves);

// A rising edge of a step signal.
struct Edge {
  std::int64_t cycle{};
  std::string what;  // axis, direction, position
};
// Of a file as `--edges` writes it.
std::vector<Edge> edges_of(const fs::path& file);

class SpooledPrint : public testing::Test {
 protected:
  explicit SpooledPrint(const std::string& name = "spooled_print");
  ~SpooledPrint() override;

  // The chip at 4 MHz, whose edges are written, at the port `port`. At `max` a print of it takes
  // some seconds.
  void begin_chip(const std::string& speed = "max", const std::vector<std::string>& more = {});
  // Its edges and its report are whole from then on.
  void end_chip();
  void begin_spooler(const std::string& printer, const std::vector<std::string>& more = {});
  void kill_spooler();
  // The first part of this pattern that it says.
  std::string said_in_log(const std::string& pattern);
  int port() const;  // of the web server

  std::string curl(std::vector<std::string> arguments) const;
  json state() const { return json::parse(curl({address + "/api/v1/state"}), nullptr, false); }
  std::string job_state(int id = 1) const;
  // Commands of the first printer's job that are executed.
  std::int64_t done() const;
  // As PrusaSlicer sends it, for one printer or any; the status.
  std::string upload(const std::string& text, const std::string& name = "part.gcode",
                     const std::string& printer = {});
  void clear_bed(const std::string& printer);
  // Waits for this; fails after five minutes.
  void expect_soon(const std::function<bool()>& fits, const std::string& what);
  process::Identity noted(const std::string& printer, const char* file) const;
  void kill_feeder(const std::string& printer);
  // Ends the chip, and prints the file with `print`: the same edges in the same order.
  void expect_edges_of_print(const std::string& text, const std::vector<std::string>& more = {});

  fs::path folder;
  std::optional<process::Process> chip, spooler;
  std::string address;
};

}  // namespace host_test
