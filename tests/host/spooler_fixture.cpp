// SPDX-License-Identifier: Apache-2.0
// Starting, waiting, ending.
#include "tests/host/spooler_fixture.hpp"

#include <signal.h>

#include <chrono>
#include <fstream>

#include "directories.hpp"
#include "tools/process/process.hpp"

namespace host_test {

using namespace std::chrono_literals;

namespace {

constexpr auto patience = 60s;  // on a machine under load

process::Identity feeder_of(const std::filesystem::path& data, const std::string& name) {
  process::Identity identity;
  std::ifstream(data / "printers" / name / "feeder.process") >> identity.id >> identity.started;
  return identity;
}

}  // namespace

SpoolerTest::SpoolerTest() {
  setenv("STEPFABRIC_BUILD_DIR", BUILD_DIRECTORY, 1);
  begin_spooler();
}

SpoolerTest::~SpoolerTest() {
  end_spooler();
  for (const char* name : {"left", "right"}) process::signal(feeder_of(data(), name), SIGKILL);
}

void SpoolerTest::begin_spooler() {
  ends_ = false;
  spooler_ = std::make_unique<spooler::Spooler>(spooler::Settings{
      .data = data(),
      .printers = {{.name = "left", .port = folder_.path() / "left"},
                   {.name = "right", .port = folder_.path() / "right"}},
      .feeder_program = BUILD_DIRECTORY "/bin/stepfabric_feeder",
      .tool_program = check_program.empty() ? BUILD_DIRECTORY "/bin/stepfabric" : check_program,
      .bed_clear_limit = bed_clear_limit,
      .check_interval = check_interval});
  thread_ = std::thread([this] { spooler_->run([this] { return ends_.load(); }); });
}

void SpoolerTest::end_spooler() {
  if (!thread_.joinable()) return;
  ends_ = true;
  thread_.join();
  spooler_.reset();
}

queue::JobId SpoolerTest::upload_moves(int lines, bool held) {
  std::string text = "G28 X Y ; comment\n";
  wanted.push_back("G28 X Y");
  for (int i = 1; i < lines; ++i) {
    wanted.push_back("G1 X" + std::to_string(i % 50) + " F6000");
    text += wanted.back() + "\n";
  }
  return upload(text, "moves.gcode", held);
}

queue::JobId SpoolerTest::upload(const std::string& text, const std::string& name, bool held,
                                 const std::string& printer) {
  queue::Store::Upload file(spool().store());
  file.write(text);
  return spool().add(file, name, held, printer);
}

void SpoolerTest::expect_soon(const std::function<bool()>& fits, const std::string& what) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (!fits()) {
    if (std::chrono::steady_clock::now() > end) FAIL() << what << ": " << spool().snapshot()->text;
    std::this_thread::sleep_for(5ms);
  }
}

void SpoolerTest::expect_state(queue::JobId id, queue::JobState state) {
  expect_soon([&] { return spool().find(id).value().state == state; },
              "job " + std::to_string(id) + " is not " + std::string(name_of(state)));
}

void SpoolerTest::expect_executed(std::size_t lines) {
  expect_soon([&] { return left.executed().size() >= lines; }, "too few lines executed");
}

queue::JobId SpoolerTest::begin_print(int moves, std::size_t executed) {
  const queue::JobId id = upload_moves(moves);
  spool().set_bed_clear("left", true);
  expect_executed(executed);
  return id;
}

void SpoolerTest::restart_with(queue::JobId id, queue::JobState state) {
  end_spooler();
  {
    queue::Queue jobs(data() / "queue.db");
    jobs.set_bed_clear("left", true);
    jobs.start(id, "left");
    if (state != queue::JobState::starting) jobs.change(id, state, "");
  }
  begin_spooler();
}

void SpoolerTest::expect_printed(queue::JobId id) {
  expect_state(id, queue::JobState::finished);
  EXPECT_EQ(left.executed(), wanted);
}

nlohmann::json SpoolerTest::printer_state(const std::string& name) {
  const auto snapshot = spool().snapshot();  // which another one may replace meanwhile
  for (const auto& printer : snapshot->json.at("printers")) {
    if (printer.at("name") == name) return printer;
  }
  return {};
}

void SpoolerTest::kill_feeder(const std::string& name) { signal_feeder(SIGKILL, name); }

void SpoolerTest::signal_feeder(int signal, const std::string& name) {
  const process::Identity feeder = feeder_of(data(), name);
  ASSERT_TRUE(process::is_running(feeder));
  process::signal(feeder, signal);
}

}  // namespace host_test
