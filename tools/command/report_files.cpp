// SPDX-License-Identifier: Apache-2.0
// report.json and report.html. Where one cannot be written, the other is tried anyway.
#include "tools/command/report_files.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <functional>
#include <stdexcept>
#include <utility>

#include "sim/report/html_report.hpp"
#include "sim/report/json_report.hpp"
#include "sim/report/verdict.hpp"
#include "tools/command/output.hpp"
#include "tools/files/write_file.hpp"

namespace command {

namespace {

bool written(const std::filesystem::path& file, const std::function<std::string()>& text) {
  try {
    files::write_file(file, text());
    return true;
  } catch (const std::runtime_error& error) {
    say_to(stderr, "stepfabric: {}\n", error.what());
    return false;
  }
}

// For a symlink its target, which would have been written.
void remove_file(const std::filesystem::path& file) {
  std::error_code ignored;
  if (files::is_foreign_link(file) || !std::filesystem::is_regular_file(file, ignored)) return;
  std::filesystem::remove(std::filesystem::canonical(file, ignored), ignored);
}

const std::filesystem::path& made(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  return folder;
}

}  // namespace

// A lock of the folder itself ends with the process and leaves no file. Where a file system has no
// locks, the job goes on without.
ReportFiles::FolderLock::FolderLock(const std::filesystem::path& folder)
    : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_ < 0 || flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(descriptor_);
  throw std::runtime_error(folder.string() +
                           ": another job writes its report there; wait for its end, or choose "
                           "another folder (--report)");
}

ReportFiles::FolderLock::~FolderLock() {
  if (descriptor_ >= 0) close(descriptor_);
}

ReportFiles::ReportFiles(std::filesystem::path folder, std::string file, std::uint32_t clock_hz)
    : folder_(std::move(folder)),
      lock_(made(folder_)),
      file_(std::move(file)),
      clock_hz_(clock_hz) {
  const report::Results beginning =
      faulted("the job has not ended: it still runs, was killed, or could not write its report");
  try {
    files::write_file(folder_ / "report.json", report::to_json(beginning));
    files::write_file(page(), report::to_html(beginning, {}));
  } catch (const std::runtime_error&) {
    // On a full disk, for example: the file there is from an earlier job.
    remove_file(folder_ / "report.json");
    remove_file(page());
    throw;
  }
}

bool ReportFiles::write_refusal(const std::string& reason) const {
  return write(faulted(reason), {});
}

bool ReportFiles::write(const report::Results& results, const report::Courses& courses) const {
  const bool json = written(folder_ / "report.json", [&] { return report::to_json(results); });
  const bool html = written(page(), [&] { return report::to_html(results, courses); });
  return json && html;
}

report::Results ReportFiles::faulted(const std::string& reason) const {
  report::Results results;
  results.file = file_;
  results.outcome = report::Outcome::faulted;
  results.fault = reason;
  results.clock_hz = clock_hz_;
  report::judge(results);
  return results;
}

}  // namespace command
