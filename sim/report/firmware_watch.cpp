// SPDX-License-Identifier: Apache-2.0
// The firmware's words and its ring of accepted lines, read between two clocks.
#include "sim/report/firmware_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace report {

namespace {

// Versions of the block that have the words read here.
constexpr std::uint32_t least_version = 2;
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

std::uint32_t block_of(const sim::ElfImage& firmware) {
  const std::optional<std::uint32_t> address = firmware.symbol("statistics");
  if (!address) {
    throw std::runtime_error("the firmware has no symbol `statistics`");
  }
  return *address;
}

}  // namespace

FirmwareWatch::FirmwareWatch(const sim::ElfImage& firmware, const sim::Chip& chip)
    : chip_(chip), block_(block_of(firmware)) {
  next_wake_ = interval_clocks;
}

std::uint32_t FirmwareWatch::word(Word which) const {
  return chip_.read_memory(block_ + 4 * static_cast<std::uint32_t>(which));
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

void FirmwareWatch::begin_anew() { accepted_ = executed_ = refused_ = 0; }

void FirmwareWatch::wake(sim::Clock now) {
  next_wake_ = now + interval_clocks;
  const std::uint32_t version = word(Word::version);
  if (version == 0) {
    begin_anew();  // not started yet; or started again, by the boot loader
    return;
  }
  if (version < least_version) {
    throw std::runtime_error("this firmware does not tell which lines it accepts");
  }
  const std::uint32_t accepted = word(Word::lines_accepted);
  if (accepted - accepted_ > ring_slots) {
    throw std::runtime_error(
        fmt::format("{} accepted lines came between two looks", accepted - accepted_));
  }
  for (; accepted_ != accepted; ++accepted_) {
    if (on_accepted) {
      on_accepted(now, line(accepted_));
    }
  }
  for (const std::uint32_t executed = word(Word::commands_executed); executed_ != executed;
       ++executed_) {
    if (on_finished) {
      on_finished(now, true);
    }
  }
  for (const std::uint32_t refused = word(Word::commands_refused); refused_ != refused;
       ++refused_) {
    if (on_finished) {
      on_finished(now, false);
    }
  }
}

}  // namespace report
