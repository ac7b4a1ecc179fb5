// SPDX-License-Identifier: Apache-2.0
// Checks a job's file before it is printed: by the firmware's own parser, limits and planner, in a
// process of its own, so that no file can take the spooler with it.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <thread>

namespace spooler {

struct CheckResult {
  bool accepted = false;
  // Nothing is known of the file: the check could not be done, as on a full disk.
  bool must_be_repeated = false;
  std::string reason;  // for people, where it was not accepted
  // JSON: up to 200 refused lines with number, text and reason, up to 5000 layers, axes; or empty.
  std::string report;
  double seconds{};  // planned, without heating
  double filament_mm{};
  std::int64_t commands{};  // in `commands_file`
};

// Next to the file of the commands, with these endings instead of its own.
inline constexpr const char* path_ending = ".path";
inline constexpr const char* picture_ending = ".png";
void remove_made_with(std::filesystem::path commands_file);

// Runs `program plan`, with a lower priority than the feeders have. Where the file
// is accepted, `commands_file` is on the disk, whole and for this user alone; elsewhere what stood
// there is there still. Path and picture are next to it, also of a file with refused lines.
CheckResult check(const std::filesystem::path& program, const std::filesystem::path& file,
                  const std::filesystem::path& commands_file);

// One check at a time, in another thread.
class Checker {
 public:
  // Is given the job and its commands, next to which the other files are, in the checker's thread,
  // where a file was accepted. Where it throws, the check is repeated.
  using Publish = std::function<void(std::int64_t job, std::filesystem::path commands_file)>;

  explicit Checker(std::filesystem::path program, Publish publish = {})
      : program_(std::move(program)), publish_(std::move(publish)) {}
  ~Checker();
  Checker(const Checker&) = delete;
  Checker& operator=(const Checker&) = delete;

  bool is_idle() const { return !thread_.joinable(); }
  void begin(std::int64_t job, const std::filesystem::path& file,
             const std::filesystem::path& commands_file);
  // The result, once, when it is there.
  std::optional<CheckResult> take_result();
  std::int64_t job() const { return job_; }
  const std::filesystem::path& commands_file() const { return commands_file_; }

 private:
  std::filesystem::path program_;
  Publish publish_;
  std::thread thread_;
  std::int64_t job_ = 0;
  std::filesystem::path commands_file_;
  CheckResult result_;
  std::atomic<bool> done_ = false;
};

}  // namespace spooler
