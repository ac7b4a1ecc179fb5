// SPDX-License-Identifier: Apache-2.0
// `stepfabric spool` as a user starts it, with co-simulated chips, and curl as a slicer.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "directories.hpp"
#include "tools/process/process.hpp"

namespace host_test {

inline const std::string stepfabric = BUILD_DIRECTORY "/bin/stepfabric";

// Moves to and fro in lines of some millimetres, after the lines `begin`.
std::string moves(int number, const std::string& begin = {});

struct Edge {
  std::int64_t cycle{};
  std::string what;  // axis, direction, position
};
std::vector<Edge> edges_of(const std::filesystem::path& file);

class SpooledPrint : public testing::Test {
 protected:
  SpooledPrint();
  ~SpooledPrint() override;

  // The chip at 4 MHz, whose edges are written. A print of it at `max` takes some seconds.
  void begin_chip(const std::string& speed = "max", const std::vector<std::string>& more = {});
  void end_chip();
  void begin_spooler(const std::string& printer);
  void kill_spooler();
  int port() const;  // of the web server

  std::string curl(std::vector<std::string> arguments) const;
  nlohmann::json state() const;
  std::string job_state(int id = 1) const;
  std::int64_t done() const;
  // As PrusaSlicer sends it; the status.
  std::string upload(const std::string& text, const std::string& name = "part.gcode",
                     const std::string& printer = {});
  void clear_bed(const std::string& printer);
  void expect_soon(const std::function<bool()>& fits, const std::string& what);
  process::Identity noted(const std::string& printer, const char* file) const;
  void kill_feeder(const std::string& printer);
  // Of the chip, which has ended, and of `print` with the same file: the same steps in their order.
  void expect_edges_of_print(const std::string& text, const std::vector<std::string>& more = {});

  std::filesystem::path folder;
  std::optional<process::Process> chip, spooler;
  std::string address;
};

}  // namespace host_test
