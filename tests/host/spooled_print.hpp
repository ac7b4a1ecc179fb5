// SPDX-License-Identifier: Apache-2.0
// A print on the co-simulated chip through `stepfabric spool`, as a user starts it.
#pragma once

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <string>
#include <thread>
#include <vector>

#include "directories.hpp"
#include "tools/files/file_text.hpp"
#include "tools/process/process.hpp"

namespace host_test {

namespace fs = std::filesystem;
using json = nlohmann::json;
using Clock = std::chrono::steady_clock;
inline const std::string stepfabric = BUILD_DIRECTORY "/bin/stepfabric";
inline constexpr std::chrono::seconds patience{300};  // on a machine under load

// Moves to and fro in lines of some millimetres.
inline std::string job(int moves) {
  std::string text = "; a job\nG28 X Y\nG90\nM82\nG92 E0\nG1 F6000\n";
  for (int i = 0; i < moves; ++i) {
    text += "G1 X" + std::to_string(5 + i % 7) + "." + std::to_string(i % 10) + " Y" +
            std::to_string(6 + i * 3 % 5) + ".25 ; line\n";
  }
  return text + "G1 X0.5 Y0\nM84\n";
}

// The edges in their order, without their times.
inline std::vector<std::string> edges_of(const fs::path& file) {
  std::vector<std::string> edges;
  std::ifstream stream(file);
  for (std::string row; std::getline(stream, row);) edges.push_back(row.substr(row.find(',') + 1));
  return edges;
}

class SpooledPrint : public testing::Test {
 protected:
  explicit SpooledPrint(const std::string& name = "spooled_print")
      : folder(fs::path(BUILD_DIRECTORY) / "scenarios" / name) {
    fs::remove_all(folder);
    fs::create_directories(folder / "runtime");
    fs::permissions(folder / "runtime", fs::perms::owner_all);
    setenv("XDG_RUNTIME_DIR", (folder / "runtime").c_str(), 1);
    setenv("STEPFABRIC_BUILD_DIR", BUILD_DIRECTORY, 1);
  }
  ~SpooledPrint() override {
    for (const char* name : {"chip", "simulated"}) kill_feeder(name);
    process::signal(noted("simulated", "chip.process"), SIGKILL);
  }

  // The chip, whose edges are written. A print of it at `max` takes some seconds.
  void begin_chip() {
    chip.emplace(process::Start{
        .arguments = {stepfabric, "serve", "--speed", "max", "--clock-hz", "4000000", "--pty",
                      folder / "port", "--edges", folder / "edges", "--report", folder / "report"},
        .output = folder / "chip.log",
        .has_input = false});
    expect_soon([&] { return fs::is_symlink(folder / "port"); }, "no port");
  }
  void begin_spooler(const std::string& printer, const std::vector<std::string>& more = {}) {
    fs::remove(folder / "spool.log");
    std::vector<std::string> call{stepfabric,           "spool",       "--data",    folder / "data",
                                  "--listen",           "127.0.0.1:0", "--printer", printer,
                                  "--simulation-speed", "max"};
    call.insert(call.end(), more.begin(), more.end());
    spooler.emplace(
        process::Start{.arguments = call, .output = folder / "spool.log", .has_input = false});
    address = said_in_log("(http://[0-9.:]+)/");
  }
  // The first part of this pattern that it says.
  std::string said_in_log(const std::string& pattern) {
    std::smatch found;
    std::string said;
    expect_soon(
        [&] {
          said = files::text_of(folder / "spool.log");
          return std::regex_search(said, found, std::regex(pattern));
        },
        "it does not say where it listens");
    return found[1];
  }
  std::string curl(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"curl", "--silent", "--show-error", "--max-time", "60"});
    return process::capture({.arguments = arguments, .has_input = false}).output;
  }
  json state() const { return json::parse(curl({address + "/api/v1/state"}), nullptr, false); }
  std::string job_state(int id = 1) const {
    const json all = state();
    if (all.is_discarded()) return "";
    for (const json& each : all.at("jobs")) {
      if (each.at("id") == id) return each.at("state");
    }
    return "";
  }
  // As PrusaSlicer sends it; the status.
  std::string upload(const std::string& text) {
    std::ofstream(folder / "part.gcode") << text;
    return curl({"--output", "/dev/null", "--write-out", "%{http_code}", "--form", "print=true",
                 "--form", "path=", "--form", "file=@" + (folder / "part.gcode").string(),
                 address + "/api/files/local"});
  }
  void clear_bed(const std::string& printer) {
    curl({"--data", R"({"clear":true})", address + "/api/v1/printers/" + printer + "/bed_clear"});
  }
  void expect_soon(const std::function<bool()>& fits, const std::string& what) {
    const auto end = Clock::now() + patience;
    while (!fits()) {
      ASSERT_LT(Clock::now(), end) << what << ": " << curl({address + "/api/v1/state"});
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }
  std::int64_t done() const {
    const json all = state();
    return all.is_discarded() ? 0 : all.at("printers").at(0).at("done").get<std::int64_t>();
  }
  process::Identity noted(const std::string& printer, const char* file) const {
    process::Identity identity;
    std::ifstream(folder / "data" / "printers" / printer / file) >> identity.id >> identity.started;
    return identity;
  }
  void kill_feeder(const std::string& printer) {
    process::signal(noted(printer, "feeder.process"), SIGKILL);
  }
  void kill_spooler() {
    spooler->signal(SIGKILL);
    spooler->wait();
    spooler.reset();
  }
  void expect_edges_of_print(const std::string& text) {
    std::ofstream(folder / "alone.gcode") << text;
    const auto alone = process::capture(
        {.arguments = {stepfabric, "print", folder / "alone.gcode", "--clock-hz", "4000000",
                       "--report", folder / "alone", "--edges", folder / "alone.edges"},
         .has_input = false});
    ASSERT_EQ(alone.exit_status, 0) << alone.output;
    chip->signal(SIGINT);
    ASSERT_EQ(chip->wait().exit_status, 0) << files::text_of(folder / "chip.log");
    const auto wanted = edges_of(folder / "alone.edges"), made = edges_of(folder / "edges");
    ASSERT_GT(wanted.size(), 10'000u);
    EXPECT_EQ(made.size(), wanted.size());
    EXPECT_TRUE(made == wanted) << "other edges, or in another order";
  }

  fs::path folder;
  std::optional<process::Process> chip, spooler;
  std::string address;
};

}  // namespace host_test
