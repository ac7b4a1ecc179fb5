// SPDX-License-Identifier: Apache-2.0
// How fast the spooler takes an upload over loopback, and the disk the same bytes alone.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace benchmarks {

struct UploadScope {
  std::filesystem::path folder;  // made and removed; the disk is its
  std::size_t bytes = 150'000'000;
  int runs = 5;
  std::function<void()> look = [] {};  // between runs; may throw to end it
};

// Seconds, one after the other in the same folder.
struct UploadRun {
  double disk{};  // written in pieces, synchronised, renamed, its folder synchronised
  double form{};  // as slicers of host type OctoPrint send it, from connect() to 201
};

struct UploadFigures {
  std::size_t bytes{};
  std::vector<UploadRun> runs;

  // Of the middle run, in MB/s.
  double speed(double UploadRun::* kind) const;
  // Of an upload's speed to the disk's: the middle of all runs.
  double ratio(double UploadRun::* kind) const;
};

// The spooler's loop stands still, so that no check takes the processor. Throws std::runtime_error
// where an upload is refused, std::system_error where the disk fails.
UploadFigures measure_uploads(const UploadScope& scope,
                              const std::function<void(const std::string&)>& say);

std::string to_json(const UploadFigures& figures);
std::string to_table(const UploadFigures& figures);

}  // namespace benchmarks
