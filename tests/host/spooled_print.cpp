// SPDX-License-Identifier: Apache-2.0
// Starting, waiting, comparing.
#include "tests/host/spooled_print.hpp"

#include <algorithm>
#include <regex>

#include "tools/files/file_text.hpp"

namespace host_test {

namespace {

constexpr std::chrono::seconds patience{300};  // on a machine under load

}  // namespace

std::string job(int moves) {
  std::string text = "; a job\nG28 X Y\nG90\nM82\nG92 E0\nG1 F6000\n";
  for (int i = 0; i < moves; ++i) {
    text += "G1 X" + std::to_string(5 + i % 7) + "." + std::to_string(i % 10) + " Y" +
            std::to_string(6 + i * 3 % 5) + ".25 ; line\n";
  }
  return text + "G1 X0.5 Y0\nM84\n";
}

std::vector<Edge> edges_of(const fs::path& file) {
  std::vector<Edge> edges;
  std::ifstream stream(file);
  std::string row;
  std::getline(stream, row);  // its header
  while (std::getline(stream, row)) {
    const std::size_t comma = row.find(',');
    edges.push_back({.cycle = std::stoll(row.substr(0, comma)), .what = row.substr(comma + 1)});
  }
  return edges;
}

SpooledPrint::SpooledPrint(const std::string& name)
    : folder(fs::path(BUILD_DIRECTORY) / "scenarios" / name) {
  fs::remove_all(folder);
  fs::create_directories(folder / "runtime");
  fs::permissions(folder / "runtime", fs::perms::owner_all);
  setenv("XDG_RUNTIME_DIR", (folder / "runtime").c_str(), 1);
  setenv("STEPFABRIC_BUILD_DIR", BUILD_DIRECTORY, 1);
}

SpooledPrint::~SpooledPrint() {
  std::error_code none;
  for (const auto& printer : fs::directory_iterator(folder / "data" / "printers", none)) {
    const std::string name = printer.path().filename().string();
    kill_feeder(name);
    process::signal(noted(name, "chip.process"), SIGKILL);
  }
}

void SpooledPrint::begin_chip(const std::string& speed, const std::vector<std::string>& more) {
  std::vector<std::string> call{stepfabric,   "serve",          "--speed",  speed,
                                "--clock-hz", "4000000",        "--pty",    folder / "port",
                                "--edges",    folder / "edges", "--report", folder / "report"};
  call.insert(call.end(), more.begin(), more.end());
  chip.emplace(
      process::Start{.arguments = call, .output = folder / "chip.log", .has_input = false});
  expect_soon([&] { return fs::is_symlink(folder / "port"); }, "no port");
}

void SpooledPrint::end_chip() {
  chip->signal(SIGINT);
  ASSERT_EQ(chip->wait().exit_status, 0) << files::text_of(folder / "chip.log");
}

void SpooledPrint::begin_spooler(const std::string& printer, const std::vector<std::string>& more) {
  fs::remove(folder / "spool.log");
  std::vector<std::string> call{stepfabric,           "spool",       "--data",    folder / "data",
                                "--listen",           "127.0.0.1:0", "--printer", printer,
                                "--simulation-speed", "max"};
  call.insert(call.end(), more.begin(), more.end());
  spooler.emplace(
      process::Start{.arguments = call, .output = folder / "spool.log", .has_input = false});
  address = said_in_log("(http://[0-9.:]+)/");
}

void SpooledPrint::kill_spooler() {
  spooler->signal(SIGKILL);
  spooler->wait();
  spooler.reset();
}

std::string SpooledPrint::said_in_log(const std::string& pattern) {
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

int SpooledPrint::port() const { return std::stoi(address.substr(address.rfind(':') + 1)); }

std::string SpooledPrint::curl(std::vector<std::string> arguments) const {
  arguments.insert(arguments.begin(), {"curl", "--silent", "--show-error", "--max-time", "60"});
  return process::capture({.arguments = arguments, .has_input = false}).output;
}

std::string SpooledPrint::job_state(int id) const {
  const json all = state();
  if (all.is_discarded()) return "";
  for (const json& each : all.at("jobs")) {
    if (each.at("id") == id) return each.at("state");
  }
  return "";
}

std::int64_t SpooledPrint::done() const {
  const json all = state();
  return all.is_discarded() ? 0 : all.at("printers").at(0).at("done").get<std::int64_t>();
}

std::string SpooledPrint::upload(const std::string& text, const std::string& name,
                                 const std::string& printer) {
  std::ofstream(folder / name) << text;
  return curl({"--output", "/dev/null", "--write-out", "%{http_code}", "--form", "print=true",
               "--form", "path=", "--form", "file=@" + (folder / name).string(),
               address + (printer.empty() ? "" : "/printers/" + printer) + "/api/files/local"});
}

void SpooledPrint::clear_bed(const std::string& printer) {
  curl({"--data", R"({"clear":true})", address + "/api/v1/printers/" + printer + "/bed_clear"});
}

void SpooledPrint::expect_soon(const std::function<bool()>& fits, const std::string& what) {
  const auto end = Clock::now() + patience;
  while (!fits()) {
    ASSERT_LT(Clock::now(), end) << what << ": " << curl({address + "/api/v1/state"});
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

process::Identity SpooledPrint::noted(const std::string& printer, const char* file) const {
  process::Identity identity;
  std::ifstream(folder / "data" / "printers" / printer / file) >> identity.id >> identity.started;
  return identity;
}

void SpooledPrint::kill_feeder(const std::string& printer) {
  process::signal(noted(printer, "feeder.process"), SIGKILL);
}

void SpooledPrint::expect_edges_of_print(const std::string& text,
                                         const std::vector<std::string>& more) {
  end_chip();
  std::ofstream(folder / "alone.gcode") << text;
  std::vector<std::string> call{stepfabric,       "print",   folder / "alone.gcode",
                                "--clock-hz",     "4000000", "--report",
                                folder / "alone", "--edges", folder / "alone.edges"};
  call.insert(call.end(), more.begin(), more.end());
  const auto alone = process::capture({.arguments = call, .has_input = false});
  ASSERT_EQ(alone.exit_status, 0) << alone.output;
  const auto wanted = edges_of(folder / "alone.edges"), made = edges_of(folder / "edges");
  ASSERT_GT(wanted.size(), 10'000u);
  EXPECT_EQ(made.size(), wanted.size());
  EXPECT_TRUE(std::ranges::equal(made, wanted, {}, &Edge::what, &Edge::what))
      << "other edges, or in another order";
}

}  // namespace host_test
