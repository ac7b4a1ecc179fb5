// SPDX-License-Identifier: Apache-2.0
// A spooler in a thread of the test, with printers at pseudo-terminals and real feeders.
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "host/spooler/spooler.hpp"
#include "tests/host/pty_printer.hpp"
#include "tests/temporary_folder.hpp"

namespace host_test {

class SpoolerTest : public testing::Test {
 protected:
  SpoolerTest();
  ~SpoolerTest() override;

  void begin_spooler();
  // As Ctrl-C does: what prints goes on.
  void end_spooler();
  spooler::Spooler& spool() { return *spooler_; }

  // A job of so many moves; its lines are added to `wanted`.
  queue::JobId upload_moves(int lines, bool held = false);
  queue::JobId upload(const std::string& text, const std::string& name = "job.gcode",
                      bool held = false, const std::string& printer = {});
  // A job of so many moves on the left printer, of which so many are executed.
  queue::JobId begin_print(int moves, std::size_t executed);
  // Another spooler, with a job in its queue that is starting or printing on the left printer, and
  // of which the feeder knows nothing.
  void restart_with(queue::JobId id, queue::JobState state);
  // Waits until it is finished: all of `wanted` was executed by the left printer, once.
  void expect_printed(queue::JobId id);
  // Waits for this; fails after a minute.
  void expect_soon(const std::function<bool()>& fits, const std::string& what);
  void expect_state(queue::JobId id, queue::JobState state);
  void expect_executed(std::size_t lines);
  nlohmann::json printer_state(const std::string& name = "left");
  // The feeder's process, from its note.
  void kill_feeder(const std::string& name = "left");
  void signal_feeder(int signal, const std::string& name = "left");
  std::filesystem::path data() const { return folder_.path() / "data"; }

  TemporaryFolder folder_;
  PtyPrinter left{folder_.path() / "left"};
  PtyPrinter right{folder_.path() / "right"};
  std::vector<std::string> wanted;
  // Of the next begin_spooler().
  std::filesystem::path check_program;  // empty: the real one
  std::chrono::milliseconds check_interval{20'000};
  std::chrono::milliseconds bed_clear_limit{0};

 private:
  std::unique_ptr<spooler::Spooler> spooler_;
  std::atomic<bool> ends_ = false;
  std::thread thread_;
};

}  // namespace host_test
