// SPDX-License-Identifier: Apache-2.0
// Reads from the chip's memory which lines the firmware has accepted and which of them it has done.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/report/task_result.hpp"
#include "sim/simulation/chip.hpp"
#include "sim/simulation/device.hpp"
#include "sim/simulation/elf_image.hpp"

namespace report {

struct AcceptedLine {
  std::optional<std::int64_t> number;  // empty for a line without one
  std::string text;  // without number and checksum, as the firmware keeps it
};

// Looks at the block of words that the firmware keeps at its symbol `statistics`
// (firmware/application/statistics.hpp), so often that no accepted line is overwritten unseen. A
// host can load any other program (M997), so the block counts only while the firmware's code and
// constants are in the memory.
class FirmwareWatch : public sim::Device {
 public:
  // Throws std::runtime_error where the firmware has no such block.
  FirmwareWatch(const sim::ElfImage& firmware, const sim::Chip& chip);

  // Called for each accepted line, once, in order; and with its outcome. (Of several that
  // are done between two looks, the executed ones come first.)
  std::function<void(sim::Clock now, const AcceptedLine& line)> on_accepted;
  std::function<void(sim::Clock now, bool executed)> on_finished;
  // The oldest accepted line is requested again instead.
  std::function<void(sim::Clock now)> on_withdrawn;
  // Another program has come into the memory, or the firmware again.
  std::function<void(sim::Clock now, bool firmware)> on_program;

  // Resend requests, since the last reset.
  std::uint64_t resends() const { return resends_; }
  // Carried out by the firmware, since the last reset.
  std::uint64_t commands_executed() const { return word(Word::commands_executed); }
  // Longest time from a wake-up of the processor to its next sleep, in clocks.
  std::uint64_t longest_pass_clocks() const { return word(Word::longest_pass_clocks); }
  // Of the main loop, in the order of a pass.
  std::vector<TaskResult> tasks() const;
  // How often the counts had gone on by more than the ring holds: lines were missed.
  std::uint64_t gaps() const { return gaps_; }
  // How often another program has taken the firmware's place.
  std::uint64_t other_programs() const { return other_programs_; }
  // Compares all of it.
  bool firmware_is_in_memory() const;

  // The chip has been reset: its counters begin at 0.
  void start_over();

  void wake(sim::Clock now) override;

 private:
  enum class Word : std::uint32_t {
    version,
    commands_executed,
    commands_refused,
    lines_accepted,
    resends,
    longest_pass_clocks = 11,
    accepted_lines,
    lines_withdrawn,
    tasks,
  };
  struct CodeWord {
    std::uint32_t address;
    std::uint32_t value;
  };

  std::uint32_t word(Word which, std::uint32_t behind = 0) const;
  AcceptedLine line(std::uint32_t index) const;
  bool is_unchanged(const CodeWord& code) const;
  void compare_some(sim::Clock now);
  void report_accepted(sim::Clock now);
  void report_finished(sim::Clock now, std::uint32_t& reported, Word count);

  const sim::Chip& chip_;
  std::uint32_t block_;
  std::vector<CodeWord> code_;
  std::size_t next_compared_ = 0;  // of the code
  bool firmware_is_there_ = true;
  std::uint32_t accepted_ = 0;
  std::uint32_t executed_ = 0;
  std::uint32_t refused_ = 0;
  std::uint32_t withdrawn_ = 0;
  std::uint32_t resends_ = 0;
  std::uint64_t gaps_ = 0;
  std::uint64_t other_programs_ = 0;
};

}  // namespace report
