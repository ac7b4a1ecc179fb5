// SPDX-License-Identifier: Apache-2.0
// What a feeder must know after it was killed, on the disk before the first byte leaves.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace feeder {

enum class Phase : std::uint8_t {
  opening,  // the numbering is being set: no line of the job has been sent
  running,
  paused,
  cancelling,  // the lines that end a cancelled job
  finished,
  cancelled,
  failed,
  interrupted,  // the printer does not know the job any more
};

constexpr bool is_over(Phase phase) { return phase >= Phase::finished; }
std::string_view name_of(Phase phase);
std::optional<Phase> phase_named(std::string_view name);

struct Record {
  std::int64_t job{};
  std::string file;  // of its commands, one a line
  std::int64_t commands{};
  std::int64_t base{};  // command 1 is sent as line base + 1
  Phase phase{Phase::opening};
  std::string why;  // of its end
};

class Journal {
 public:
  // Reads what the file holds. Throws std::runtime_error where it is no journal.
  explicit Journal(std::filesystem::path file);

  const std::optional<Record>& record() const { return record_; }
  // On the disk when it returns: written next to it, fsync, renamed, fsync of the
  // folder. Throws std::system_error.
  void write(const Record& record);
  void clear();

 private:
  std::filesystem::path file_;
  std::optional<Record> record_;
};

}  // namespace feeder
