// SPDX-License-Identifier: Apache-2.0
// The firmware's words and its ring of accepted lines, read between two clocks.
#include "sim/report/firmware_watch.hpp"

#include <algorithm>
#include <stdexcept>

#include "firmware/units/task_span.hpp"

namespace report {

namespace {

// Versions of the block that have the words read here.
constexpr std::uint32_t least_version = 4;
constexpr std::uint32_t ring_slots = 8;
constexpr std::uint32_t slot_bytes = 136;
constexpr std::uint32_t text_bytes = 128;
constexpr std::uint32_t number_offset = 128;
// As firmware/host_link/line_number.hpp has it.
constexpr std::uint32_t before_first = 0xffff'ffff;
constexpr std::uint32_t length_offset = 132;  // with `numbered` in the byte above it
// The firmware overwrites a slot only in a later pass of its loop, and a pass with a line to take
// costs more instructions than this.
constexpr sim::Clock interval_clocks = 1'000;
// Of the code, in one look: all of it within 0.2 million clocks, which is less than the time from
// the first bytes of another program to its start.
constexpr std::size_t words_per_look = 64;

std::uint32_t block_of(const sim::ElfImage& firmware) {
  const std::optional<std::uint32_t> address = firmware.symbol("statistics");
  if (!address) throw std::runtime_error("the firmware has no symbol `statistics`");
  return *address;
}

}  // namespace

FirmwareWatch::FirmwareWatch(const sim::ElfImage& firmware, const sim::Chip& chip)
    : chip_(chip), block_(block_of(firmware)) {
  for (const sim::ElfConstants& constants : firmware.constants) {
    // After the block lies the boot loader, which is no part of the program.
    if (constants.address >= block_) continue;
    for (const sim::ElfSegment& segment : firmware.segments) {
      const std::uint64_t end =
          std::min<std::uint64_t>(std::uint64_t{constants.address} + constants.size_bytes,
                                  segment.address + segment.bytes.size());
      for (std::uint64_t at = (std::uint64_t{constants.address} + 3) / 4 * 4;
           at >= segment.address && at + 4 <= end; at += 4) {
        CodeWord code{static_cast<std::uint32_t>(at), 0};
        for (std::uint32_t i = 0; i < 4; ++i) {
          code.value |= std::uint32_t{segment.bytes[at - segment.address + i]} << (8 * i);
        }
        code_.push_back(code);
      }
    }
  }
  next_wake_ = interval_clocks;
}

std::uint32_t FirmwareWatch::word(Word which, std::uint32_t behind) const {
  return chip_.read_memory(block_ + 4 * (static_cast<std::uint32_t>(which) + behind));
}

std::vector<TaskResult> FirmwareWatch::tasks() const {
  std::vector<TaskResult> results;
  for (std::uint32_t task = 0; task < units::task_count; ++task) {
    results.push_back({.name = std::string(units::task_names[task]),
                       .longest_clocks = word(Word::tasks, 2 * task),
                       .overruns = word(Word::tasks, 2 * task + 1)});
  }
  return results;
}

AcceptedLine FirmwareWatch::line(std::uint32_t index) const {
  const std::uint32_t slot = word(Word::accepted_lines) + index % ring_slots * slot_bytes;
  const std::uint32_t lengths = chip_.read_memory(slot + length_offset);
  const std::uint32_t length = std::min(lengths & 0xff, text_bytes);
  AcceptedLine line;
  if ((lengths >> 8 & 0xff) != 0) {
    const std::uint32_t number = chip_.read_memory(slot + number_offset);
    line.number = number == before_first ? -1 : std::int64_t{number};
  }
  for (std::uint32_t i = 0; i < length; ++i) {
    line.text += static_cast<char>(chip_.read_memory(slot + i / 4 * 4) >> (8 * (i % 4)));
  }
  return line;
}

bool FirmwareWatch::is_unchanged(const CodeWord& code) const {
  return chip_.read_memory(code.address) == code.value;
}

bool FirmwareWatch::firmware_is_in_memory() const {
  return std::ranges::all_of(code_, [this](const CodeWord& code) { return is_unchanged(code); });
}

void FirmwareWatch::start_over() { accepted_ = executed_ = refused_ = withdrawn_ = resends_ = 0; }

void FirmwareWatch::compare_some(sim::Clock now) {
  if (code_.empty()) return;
  bool equal = true;
  for (std::size_t i = 0; i < std::min(words_per_look, code_.size()) && equal; ++i) {
    equal = is_unchanged(code_[next_compared_]);
    next_compared_ = (next_compared_ + 1) % code_.size();
  }
  // One difference is enough to lose the firmware; finding it again takes a comparison of all of
  // the code.
  const bool there = firmware_is_there_ ? equal : equal && firmware_is_in_memory();
  if (there == firmware_is_there_) return;
  firmware_is_there_ = there;
  other_programs_ += there ? 0 : 1;
  start_over();
  if (on_program) on_program(now, there);
}

void FirmwareWatch::report_accepted(sim::Clock now) {
  const std::uint32_t accepted = word(Word::lines_accepted);
  if (accepted - accepted_ > ring_slots) {
    ++gaps_;
    accepted_ = accepted;
  }
  for (; accepted_ != accepted; ++accepted_) {
    const AcceptedLine taken = line(accepted_);
    if (on_accepted) on_accepted(now, taken);
  }
}

void FirmwareWatch::report_finished(sim::Clock now, std::uint32_t& reported, Word count) {
  const std::uint32_t finished = word(count);
  if (finished - reported > ring_slots) {
    ++gaps_;
    reported = finished;
  }
  for (; reported != finished; ++reported) {
    if (count == Word::lines_withdrawn) {
      if (on_withdrawn) on_withdrawn(now);
    } else if (on_finished) {
      on_finished(now, count == Word::commands_executed);
    }
  }
}

void FirmwareWatch::wake(sim::Clock now) {
  next_wake_ = now + interval_clocks;
  compare_some(now);
  if (!firmware_is_there_) return;
  if (word(Word::version) < least_version) {
    start_over();  // not started yet; or started again, by the boot loader
    return;
  }
  resends_ = word(Word::resends);
  try {
    report_accepted(now);
  } catch (const std::out_of_range&) {
    // The ring's address is outside the memory: a stray store, or a debugger.
    ++gaps_;
    accepted_ = word(Word::lines_accepted);
  }
  report_finished(now, executed_, Word::commands_executed);
  report_finished(now, refused_, Word::commands_refused);
  report_finished(now, withdrawn_, Word::lines_withdrawn);
}

}  // namespace report
