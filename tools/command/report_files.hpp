// SPDX-License-Identifier: Apache-2.0
// The files of a job's report, which belong to this job from its start.
#pragma once

#include <filesystem>
#include <string>

#include "sim/report/results.hpp"

namespace command {

class ReportFiles {
 public:
  // Writes a report that says that the job has not ended: a kill leaves it, and no earlier one
  // stands for this job. Throws std::runtime_error where folder or files cannot be written, or
  // where another job has the folder, until that ends.
  ReportFiles(std::filesystem::path folder, std::string file, std::uint32_t clock_hz);

  // For a job that ended for this reason before anything was simulated. Returns whether both files
  // are written; errors go to standard error.
  bool write_refusal(const std::string& reason) const;
  // The same of a whole job.
  bool write(const report::Results& results, const report::Courses& courses) const;

  std::filesystem::path page() const { return folder_ / "report.html"; }

 private:
  class FolderLock {
   public:
    explicit FolderLock(const std::filesystem::path& folder);
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;
    ~FolderLock();

   private:
    int descriptor_;
  };

  report::Results faulted(const std::string& reason) const;

  std::filesystem::path folder_;
  FolderLock lock_;
  std::string file_;  // that is printed; empty for `serve`
  std::uint32_t clock_hz_;
};

}  // namespace command
