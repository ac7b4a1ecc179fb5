// SPDX-License-Identifier: Apache-2.0
// The host's end against the loader's, with errors on the line between them.
#include "tools/loading/loading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <fstream>
#include <optional>
#include <random>
#include <utility>

#include "firmware/boot_loader/session.hpp"

namespace {

using namespace boot_loader;
using loading::LoadFailed;
using loading::Program;
using std::chrono::milliseconds;

// Of a program.
constexpr std::size_t most_bytes = loading::program_end - loading::memory_address;
constexpr std::uint32_t address = loading::memory_address;
constexpr std::uint32_t old_entry = address + 8;

Program random_program(std::size_t bytes) {
  std::mt19937 random(3);
  Program program{.address = address, .bytes = std::vector<std::uint8_t>(bytes), .entry = address};
  for (auto& byte : program.bytes) byte = static_cast<std::uint8_t>(random());
  return program;
}

// A chip that listens once it has heard M997, or has been reset while the host knocks.
class Chip : public loading::ByteStream {
 public:
  // What arrives of a byte; nothing where it is lost.
  using Wire = std::function<std::optional<std::uint8_t>(std::uint8_t)>;

  void write(std::span<const std::uint8_t> bytes) override {
    for (const std::uint8_t byte : bytes) {
      if (vanishes_after == 0) throw LoadFailed("the host is gone");
      --vanishes_after;
      if (const auto arrived = to_chip(byte)) hear(*arrived);
    }
  }

  std::size_t read(std::span<std::uint8_t> bytes, milliseconds timeout) override {
    if (to_read_.empty()) stay_silent();
    if (to_read_.empty() || to_read_.front().second > now_ + timeout) {
      now_ += timeout;
      return 0;
    }
    now_ = std::max(now_, to_read_.front().second);
    std::size_t count = 0;
    while (count < bytes.size() && !to_read_.empty() && to_read_.front().second <= now_) {
      bytes[count++] = to_read_.front().first;
      to_read_.pop_front();
    }
    return count;
  }

  Wire to_chip = [](std::uint8_t byte) { return byte; };
  Wire to_host = [](std::uint8_t byte) { return byte; };
  std::size_t vanishes_after = ~std::size_t{0};  // bytes from the host
  bool knows_m997 = true;
  unsigned reset_after_knocks = 0;  // 0: it is never reset
  std::optional<std::size_t> stuck_byte;  // of the memory
  milliseconds time_per_frame{0};  // until its answer is there, one frame after the other
  std::vector<std::uint8_t> memory =
      std::vector<std::uint8_t>(loading::program_end - loading::memory_address);
  Session session{memory, address, old_entry, {}};

 private:
  void hear(std::uint8_t byte) {
    if (!listening_) {
      heard_ += static_cast<char>(byte);
      knocked_ = byte == knock ? knocked_ + 1 : 0;
      total_knocks_ += byte == knock ? 1 : 0;
      const bool reset = reset_after_knocks != 0 && total_knocks_ > reset_after_knocks;
      listening_ = (knows_m997 && heard_.ends_with("M997\n")) || (reset && knocked_ >= knocks);
      return;
    }
    if (!receiver_.receive(byte)) return;
    const Answer answer = session.handle(receiver_.frame());
    if (stuck_byte) memory[*stuck_byte] = 0;
    say(answer);
  }

  void stay_silent() {
    if (listening_ && !receiver_.silence()) say(Session::refuse(Refusal::damaged));
  }

  void say(const Answer& answer) {
    ready_ = std::max(ready_, now_) + time_per_frame;
    for (const std::uint8_t byte : answer.bytes()) {
      if (const auto arrived = to_host(byte)) to_read_.emplace_back(*arrived, ready_);
    }
  }

  FrameReceiver receiver_;
  std::string heard_;
  unsigned knocked_ = 0, total_knocks_ = 0;
  bool listening_ = false;
  std::deque<std::pair<std::uint8_t, milliseconds>> to_read_;  // with the time of its arrival
  milliseconds now_{0}, ready_{0};
};

// Corrupts or loses one byte in this many.
Chip::Wire bad_wire(unsigned one_in, unsigned seed) {
  return [one_in, random = std::mt19937(seed)](std::uint8_t byte) mutable {
    if (random() % one_in != 0) return std::optional(byte);
    if (random() % 2 == 0) return std::optional<std::uint8_t>();
    return std::optional(static_cast<std::uint8_t>(byte ^ 1u << random() % 8));
  };
}

void expect_started(const Chip& chip, const Program& program) {
  EXPECT_TRUE(chip.session.start_wanted());
  EXPECT_EQ(chip.session.entry(), program.entry);
  EXPECT_TRUE(std::equal(program.bytes.begin(), program.bytes.end(),
                         chip.memory.begin() + (program.address - address)));
}

TEST(loading, a_program_arrives_over_a_good_line_without_repetition) {
  Chip chip;
  Program program = random_program(45'001);
  program.address += 16;
  program.entry = program.address + 128;
  std::size_t reported = 0;
  const auto figures =
      loading::load(chip, program, {.sent = [&](std::size_t sent) { reported = sent; }});
  expect_started(chip, program);
  EXPECT_EQ(reported, program.bytes.size());
  EXPECT_EQ(figures.repeated_frames, 0u);
  EXPECT_EQ(figures.restarts, 0u);
}

// Simulated on a busy machine: every repetition costs it time too.
TEST(loading, a_chip_that_needs_a_second_for_each_frame_is_waited_for) {
  Chip chip;
  chip.time_per_frame = milliseconds(1000);
  const Program program = random_program(45'000);
  const auto figures = loading::load(chip, program);
  expect_started(chip, program);
  EXPECT_GT(figures.repeated_frames, 0u);
  EXPECT_EQ(figures.restarts, 0u);
}

TEST(loading, it_arrives_whole_whatever_bytes_are_corrupted_or_lost) {
  unsigned repeated = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    Chip chip;
    chip.to_chip = bad_wire(2000, seed);
    chip.to_host = bad_wire(200, seed + 1000);
    const Program program = random_program(20'000);
    repeated += loading::load(chip, program).repeated_frames;
    expect_started(chip, program);
  }
  EXPECT_GT(repeated, 200u);
}

TEST(loading, a_line_that_passes_no_frame_ends_in_a_failure_and_starts_nothing) {
  Chip chip;
  const Program program = random_program(5000);
  std::size_t passed = 0;
  chip.to_chip = [&](std::uint8_t byte) {
    return ++passed > 2000 ? std::optional(static_cast<std::uint8_t>(byte ^ 1u)) : byte;
  };
  EXPECT_THROW(loading::load(chip, program), LoadFailed);
  EXPECT_EQ(chip.session.entry(), std::nullopt);
  EXPECT_FALSE(chip.session.start_wanted());
}

TEST(loading, a_host_that_vanishes_leaves_nothing_to_start_and_the_next_one_loads) {
  Chip chip;
  const Program program = random_program(5000);
  chip.vanishes_after = 3000;
  EXPECT_THROW(loading::load(chip, program), LoadFailed);
  EXPECT_EQ(chip.session.entry(), std::nullopt);
  chip.vanishes_after = ~std::size_t{0};
  loading::load(chip, program);
  expect_started(chip, program);
}

TEST(loading, memory_that_does_not_keep_it_is_found_and_nothing_starts) {
  Chip chip;
  const Program program = random_program(5000);
  chip.stuck_byte = 4321;
  ASSERT_NE(program.bytes[4321], 0);
  EXPECT_THROW(loading::load(chip, program), LoadFailed);
  EXPECT_EQ(chip.session.entry(), std::nullopt);
}

TEST(loading, a_program_that_is_too_large_is_refused_before_anything_is_void) {
  Chip chip;
  EXPECT_THROW(loading::load(chip, random_program(most_bytes + 1)), LoadFailed);
  EXPECT_EQ(chip.session.entry(), old_entry);
}

TEST(loading, a_chip_that_does_not_answer_is_knocked_at_until_it_is_reset) {
  Chip chip;
  chip.knows_m997 = false;
  chip.reset_after_knocks = 500;
  const Program program = random_program(700);
  loading::load(chip, program);
  expect_started(chip, program);
}

TEST(loading, where_there_is_no_loader_that_is_said) {
  Chip chip;
  chip.knows_m997 = false;
  EXPECT_THROW(loading::load(chip, random_program(700)), LoadFailed);
  EXPECT_EQ(chip.session.entry(), old_entry);
}

// Another device at the port, say.
TEST(loading, a_line_that_never_rests_ends_in_a_failure) {
  struct Chatter : loading::ByteStream {
    void write(std::span<const std::uint8_t>) override {}
    std::size_t read(std::span<std::uint8_t> bytes, std::chrono::milliseconds) override {
      std::ranges::fill(bytes, std::uint8_t{'x'});
      return bytes.size();
    }
  };
  Chatter chatter;
  EXPECT_THROW(loading::load(chatter, random_program(700)), LoadFailed);
}

TEST(loading, plain_bytes_begin_where_the_memory_does) {
  const auto file = std::filesystem::temp_directory_path() / "stepfabric_loading_test.bin";
  std::ofstream(file, std::ios::binary) << std::string("abc\0ef", 6);
  const Program program = loading::read_program(file);
  EXPECT_EQ(program.address, address);
  EXPECT_EQ(program.entry, address);
  EXPECT_EQ(program.bytes.size(), 6u);
  std::ofstream(file, std::ios::binary) << std::string(most_bytes + 1, 'x');
  EXPECT_THROW(loading::read_program(file), std::runtime_error);
  std::ofstream(file, std::ios::binary) << "";
  EXPECT_THROW(loading::read_program(file), std::runtime_error);
  std::filesystem::remove(file);
  EXPECT_THROW(loading::read_program(file), std::runtime_error);
}

std::string refusal_of(std::string_view contents) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(contents.data());
  try {
    loading::parse_program({bytes, contents.size()}, "part.gcode");
  } catch (const std::runtime_error& refusal) {
    return refusal.what();
  }
  return {};
}

// With the line ends and the encodings that slicers write.
TEST(loading, g_code_is_refused_and_print_is_named) {
  for (const char* text :
       {"G28\nG1 X5\n", "; caf\xc3\xa9\r\n\tG28\r\n", "; caf\xe9\nG28\n", "M117 \\o/"}) {
    EXPECT_NE(refusal_of(text).find("part.gcode is text, no program"), std::string::npos) << text;
    EXPECT_NE(refusal_of(text).find("`stepfabric print`"), std::string::npos) << text;
  }
  EXPECT_EQ(refusal_of({"o\0\0\0", 4}), "");
}

TEST(loading, what_cannot_be_read_to_its_end_is_refused) {
  EXPECT_THROW(loading::read_program("/dev/zero"), std::runtime_error);
  EXPECT_THROW(loading::read_program(std::filesystem::temp_directory_path()), std::runtime_error);
}

}  // namespace
