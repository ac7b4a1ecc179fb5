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
  cancelling,  // the lines that switch everything off are being sent; then comes the outcome
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
  Phase outcome{Phase::cancelled};  // what follows on `cancelling`
  double hotend_to_restore{};  // in degrees, before the next line: a long pause has switched it off
};

class Journal {
 public:
  // Reads what the file holds. What is no journal is set aside as FILE.damaged, and `damage` says
  // so. Throws std::filesystem::filesystem_error where that cannot be done.
  explicit Journal(std::filesystem::path file);

  const std::optional<Record>& record() const { return record_; }
  // On the disk when it returns: written next to it, fsync, exchanged, fsync of the folder. Throws
  // std::system_error; then the record is the one before. The two files keep their blocks, so
  // that only the first record needs space on the disk.
  void write(const Record& record);
  // The record counts at once, also where the disk refuses it: then `fault` says so, and retry()
  // is to be called now and then.
  void note(const Record& record);
  void retry();
  // Throws std::system_error.
  void clear();

  // Why the disk has an older record; empty: it has this one.
  const std::string& fault() const { return fault_; }
  // Why the last record is lost; empty from the next write() on.
  const std::string& damage() const { return damage_; }

 private:
  std::filesystem::path spare() const { return file_.string() + ".new"; }
  void fill_spare(std::string text) const;
  void put(const Record& record) const;

  std::filesystem::path file_;
  std::optional<Record> record_;
  std::string fault_, damage_;
};

}  // namespace feeder
