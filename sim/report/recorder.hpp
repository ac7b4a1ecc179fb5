// SPDX-License-Identifier: Apache-2.0
// All recorders of a print, and the results at its end.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "sim/devices/host_listener.hpp"
#include "sim/machine/printer.hpp"
#include "sim/report/axis_courses.hpp"
#include "sim/report/chip_record.hpp"
#include "sim/report/edge_file.hpp"
#include "sim/report/message_log.hpp"
#include "sim/report/point_check.hpp"
#include "sim/report/refusal_log.hpp"
#include "sim/report/requested_path.hpp"
#include "sim/report/results.hpp"
#include "sim/report/step_statistics.hpp"
#include "sim/report/temperature_record.hpp"
#include "sim/report/tool_path.hpp"
#include "sim/simulation/elf_image.hpp"
#include "sim/simulation/simulation.hpp"

namespace report {

class Recorder : public devices::HostListener {
 public:
  // Listens from now on; to be made before the simulation runs. `edges` empty: no file of edges.
  Recorder(machine::Printer& printer, devices::Host& host, sim::Simulation& simulation,
           const std::filesystem::path& edges);

  void command_acknowledged(sim::Clock now, std::size_t file_line, std::string_view command,
                            bool executed) override;

  // Of the simulation so far. Outcome, fault, names, wall time and lines that were lost with the
  // print's end are the caller's, and then the verdict.
  Results results(const sim::ElfImage& firmware) const;
  Courses courses() const;
  // Writes all edges so far to their file, so that a killed job leaves them.
  void flush_edges();
  // Throws std::runtime_error after a write error.
  void close_edges();
  // True after a write error, which close_edges() reports.
  bool edges_failed() const;

 private:
  AxisResult axis_result(std::size_t axis) const;
  void add_findings(Results& results) const;

  machine::Printer& printer_;
  devices::Host& host_;
  sim::Simulation& simulation_;
  PointCheck points_;
  RefusalLog refusals_;
  ToolPath tool_path_;
  RequestedPath requested_path_;
  AxisCourses axis_courses_;
  StepStatistics steps_;
  ChipRecord chip_record_;
  TemperatureRecord hotend_;
  TemperatureRecord bed_;
  std::optional<TemperatureRecord> second_hotend_;
  MessageLog messages_;
  std::unique_ptr<EdgeFile> edges_;
};

// Bytes of the stack that were ever used, from the paint that the firmware's start-up left; 0 where
// the image has no symbols `_stack_bottom` and `_stack_top`.
std::uint32_t stack_peak_bytes(const sim::ElfImage& firmware, const sim::Chip& chip);

}  // namespace report
