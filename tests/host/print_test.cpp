// SPDX-License-Identifier: Apache-2.0
// Whole prints on the co-simulated chip, through `stepfabric spool` as a user starts it: uploaded
// by curl as PrusaSlicer does, with both processes killed on the way, to the step.
#include <gmock/gmock.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <sstream>
#include <thread>

#include "directories.hpp"
#include "tests/temporary_folder.hpp"
#include "tools/files/file_text.hpp"
#include "tools/process/process.hpp"

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using nlohmann::json;
using testing::HasSubstr;
using Clock = std::chrono::steady_clock;
const std::string stepfabric = BUILD_DIRECTORY "/bin/stepfabric";
constexpr auto patience = 300s;  // on a machine under load

// Moves to and fro in lines of some millimetres.
std::string job(int moves) {
  std::string text = "; a job\nG28 X Y\nG90\nM82\nG92 E0\nG1 F6000\n";
  for (int i = 0; i < moves; ++i) {
    text += "G1 X" + std::to_string(5 + i % 7) + "." + std::to_string(i % 10) + " Y" +
            std::to_string(6 + i * 3 % 5) + ".25 ; line\n";
  }
  return text + "G1 X0.5 Y0\nM84\n";
}

// The edges in their order, without their times.
std::vector<std::string> edges_of(const fs::path& file) {
  std::vector<std::string> edges;
  std::ifstream stream(file);
  for (std::string row; std::getline(stream, row);) edges.push_back(row.substr(row.find(',') + 1));
  return edges;
}

class SpooledPrint : public testing::Test {
 protected:
  SpooledPrint() : folder(fs::path(BUILD_DIRECTORY) / "scenarios" / "spooled_print") {
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
  void begin_spooler(const std::string& printer) {
    fs::remove(folder / "spool.log");
    spooler.emplace(process::Start{
        .arguments = {stepfabric, "spool", "--data", folder / "data", "--listen", "127.0.0.1:0",
                      "--printer", printer, "--simulation-speed", "max"},
        .output = folder / "spool.log",
        .has_input = false});
    std::smatch found;
    std::string said;
    expect_soon(
        [&] {
          said = files::text_of(folder / "spool.log");
          return std::regex_search(said, found, std::regex("(http://[0-9.:]+)/"));
        },
        "it does not say where it listens");
    address = found[1];
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
      std::this_thread::sleep_for(20ms);
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

TEST_F(SpooledPrint, makes_the_edges_of_print_though_feeder_and_spooler_are_killed) {
  const std::string text = job(400);
  begin_chip();
  begin_spooler("chip=" + (folder / "port").string());
  EXPECT_EQ(upload(text), "201");
  clear_bed("chip");
  for (const std::int64_t line : {80, 160}) {
    expect_soon([&] { return done() >= line; }, "no progress");
    ASSERT_EQ(job_state(), "printing");
    kill_feeder("chip");
    expect_soon([&] { return done() > line + 40; }, "it does not go on after the kill");
  }
  ASSERT_LT(done(), 360) << "printed before the spooler was killed";
  kill_spooler();
  const auto edges = fs::file_size(folder / "edges");
  expect_soon([&] { return fs::file_size(folder / "edges") > edges; }, "no edge without spooler");
  begin_spooler("chip=" + (folder / "port").string());
  expect_soon([&] { return job_state() == "finished"; }, "not finished");
  expect_edges_of_print(text);
  EXPECT_EQ(state().at("jobs").at(0).at("starts"), 1);
}

TEST_F(SpooledPrint, prints_on_a_simulated_printer_that_it_starts_itself) {
  begin_spooler("simulated");
  EXPECT_EQ(upload("G28 X\nG1 X20 F6000\nG1 X5\n"), "201");
  clear_bed("simulated");
  expect_soon([&] { return job_state() == "finished"; }, "not finished");
  spooler->signal(SIGINT);
  EXPECT_EQ(spooler->wait().exit_status, 0);
  // Nothing is left running where nothing is printed.
  expect_soon(
      [&] {
        return !process::is_running(noted("simulated", "feeder.process")) &&
               !process::is_running(noted("simulated", "chip.process"));
      },
      "feeder or chip go on");
}

// What a spooler says that cannot start.
process::Captured refused(const fs::path& data, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {stepfabric, "spool", "--data", data.string()});
  return process::capture({.arguments = arguments, .has_input = false});
}

TEST_F(SpooledPrint, refuses_to_start_where_it_may_not) {
  const auto open = refused(folder / "data", {"--listen", "0.0.0.0:0", "--allow-root"});
  EXPECT_EQ(open.exit_status, 2);
  EXPECT_THAT(open.output, HasSubstr("--key"));
  EXPECT_EQ(refused(folder / "data", {"--printer", "left"}).exit_status, 2);
  EXPECT_EQ(refused(folder / "data", {"--listen", "here:there"}).exit_status, 2);
}

TEST_F(SpooledPrint, does_not_serve_others_as_root_and_names_the_remedy) {
  if (geteuid() != 0) GTEST_SKIP() << "this user is not root";
  const auto as_root = refused(folder / "data", {"--listen", "0.0.0.0:0"});
  EXPECT_EQ(as_root.exit_status, 2);
  EXPECT_THAT(as_root.output,
              testing::AllOf(HasSubstr("sudo -u"), HasSubstr("User="), HasSubstr("--allow-root")));
}

}  // namespace
