// SPDX-License-Identifier: Apache-2.0
// Serves host programs: the printer's serial line on a pseudo-terminal.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "sim/devices/pseudo_terminal.hpp"
#include "sim/report/accept_log.hpp"
#include "sim/report/recorder.hpp"
#include "sim/report/served_host.hpp"
#include "tools/command/pacer.hpp"
#include "tools/command/printer_setup.hpp"
#include "tools/command/progress.hpp"
#include "tools/command/serve_job.hpp"

namespace command {

class Service {
 public:
  // `options` must outlive this, with its terminal and clock chosen.
  explicit Service(const ServeOptions& options);

  // Prints where to connect, and the path of the report.
  void greet(const std::filesystem::path& page);
  // Until interrupted, or until the time of the options.
  void run();

  report::Results results();
  report::Courses courses() const { return recorder_.courses(); }
  // The first error in writing the edges or the accepted lines, or nothing.
  std::string close_files();

 private:
  void listen();
  void opened();
  // A chip that is starting does not receive. A program that never greets gets its bytes after
  // a time-out.
  void hold_back();
  void reset();
  void say(const std::string& text);
  void show_status();
  std::string connection() const;
  // The host prints, so the service goes on.
  void complain_if_disk_is_full();
  // The time-outs of hosts run in real time.
  void complain_if_slow(double ratio, double seconds);

  const ServeOptions& options_;
  PrinterSetup setup_;
  sim::Simulation& simulation_;
  devices::PseudoTerminal terminal_;
  report::FirmwareWatch watch_;
  report::ServedHost host_;
  report::Recorder recorder_;
  std::optional<report::AcceptLog> accept_log_;
  Pacer pacer_;
  Progress progress_;
  bool reset_wanted_ = false;
  double held_since_ = 0;
  bool firmware_is_there_ = true;
  double shown_wall_ = 0, shown_seconds_ = 0;
  std::uint64_t shown_lines_ = 0;
  double slow_for_ = 0;
  bool complained_ = false;
  bool disk_is_full_ = false;
};

}  // namespace command
