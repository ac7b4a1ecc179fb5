// SPDX-License-Identifier: Apache-2.0
// What the firmware keeps of accepted lines in its memory becomes the accept log and a host to
// listen to.
#include "sim/report/accept_log.hpp"

#include <gmock/gmock.h>

#include <map>
#include <string>
#include <vector>

#include "sim/report/firmware_watch.hpp"
#include "sim/report/served_host.hpp"
#include "tests/sim/fake_chip.hpp"

namespace {

using report::AcceptedLine;
using testing::ElementsAre;

constexpr std::uint32_t block = tests::FakeChip::memory_start + 0x100;
constexpr std::uint32_t ring = tests::FakeChip::memory_start + 0x1000;

// The firmware's side of the contract, as its statistics.hpp describes it.
class Firmware {
 public:
  void start() {
    set(0, 4);
    set(12, ring);
  }
  void accept(const std::string& text, std::optional<std::int32_t> number) {
    const std::uint32_t slot = ring + accepted_ % 8 * 136;
    for (std::uint32_t i = 0; i < text.size(); i += 4) {
      std::uint32_t word = 0;
      for (std::uint32_t j = 0; j < 4 && i + j < text.size(); ++j) {
        word |= static_cast<std::uint32_t>(static_cast<unsigned char>(text[i + j])) << 8 * j;
      }
      chip.write_memory(slot + i, word);
    }
    chip.write_memory(slot + 128, static_cast<std::uint32_t>(number.value_or(0)));
    chip.write_memory(slot + 132,
                      static_cast<std::uint32_t>(text.size()) | (number.has_value() ? 0x100U : 0U));
    set(3, ++accepted_);
  }
  void finish(bool executed) { executed ? set(1, ++executed_) : set(2, ++refused_); }
  void withdraw() { set(13, ++withdrawn_); }
  void set(std::uint32_t word, std::uint32_t value) { chip.write_memory(block + 4 * word, value); }

  tests::FakeChip chip;
  sim::ElfImage image{.segments = {}, .sizes = {}, .entry = 0, .symbols = {{"statistics", block}}};

 private:
  std::uint32_t accepted_ = 0, executed_ = 0, refused_ = 0, withdrawn_ = 0;
};

TEST(FirmwareWatch, names_the_tasks_with_their_times) {
  Firmware firmware;
  report::FirmwareWatch watch(firmware.image, firmware.chip);
  firmware.start();
  for (std::uint32_t word = 0; word < 18; ++word) firmware.set(14 + word, 100 + word);
  const auto tasks = watch.tasks();
  ASSERT_EQ(tasks.size(), 9U);
  EXPECT_EQ(tasks[0].name, "motion");
  EXPECT_EQ(tasks[0].longest_clocks, 100U);
  EXPECT_EQ(tasks[0].overruns, 101U);
  EXPECT_EQ(tasks[8].name, "rest");
  EXPECT_EQ(tasks[8].overruns, 117U);
}

TEST(FirmwareWatch, reports_every_accepted_line_once_and_in_order) {
  Firmware firmware;
  report::FirmwareWatch watch(firmware.image, firmware.chip);
  std::string log;
  watch.on_accepted = [&](sim::Clock, const AcceptedLine& line) {
    log += report::accept_log_row(line);
  };
  watch.wake(1000);
  firmware.start();
  watch.wake(2000);
  firmware.accept("M110", -1);
  firmware.accept("G1 X10 Y20", 100'000);
  watch.wake(3000);
  for (int i = 0; i < 8; ++i) firmware.accept("M105", std::nullopt);
  watch.wake(4000);
  watch.wake(5000);
  std::string expected = "-1\tM110\n100000\tG1 X10 Y20\n";
  for (int i = 0; i < 8; ++i) expected += "-\tM105\n";
  EXPECT_EQ(log, expected);
}

TEST(FirmwareWatch, passes_on_each_line_that_is_asked_for_again) {
  Firmware firmware;
  report::FirmwareWatch watch(firmware.image, firmware.chip);
  int finished = 0;
  int withdrawn = 0;
  watch.on_finished = [&](sim::Clock, bool) { ++finished; };
  watch.on_withdrawn = [&](sim::Clock) { ++withdrawn; };
  watch.wake(1000);
  firmware.start();
  watch.wake(2000);
  firmware.accept("G1 X10", 1);
  firmware.accept("G1 X", 2);
  watch.wake(3000);
  firmware.finish(true);
  firmware.withdraw();
  watch.wake(4000);
  EXPECT_EQ(finished, 1);
  EXPECT_EQ(withdrawn, 1);
}

TEST(FirmwareWatch, counts_from_0_where_the_firmware_starts_again) {
  Firmware firmware;
  report::FirmwareWatch watch(firmware.image, firmware.chip);
  std::size_t lines = 0;
  watch.on_accepted = [&](sim::Clock, const AcceptedLine&) { ++lines; };
  firmware.start();
  firmware.accept("M997", std::nullopt);
  watch.wake(1000);
  for (const std::uint32_t word : {0u, 1u, 2u, 3u, 12u}) firmware.set(word, 0);
  watch.wake(2000);
  firmware.start();
  ASSERT_NO_THROW(watch.wake(3000));
  firmware.set(3, 1);
  watch.wake(4000);
  EXPECT_EQ(lines, 2u);
}

// A peer may load any program (M997): what that leaves in the firmware's words means nothing.
TEST(FirmwareWatch, is_silent_while_another_program_is_in_the_memory) {
  Firmware firmware;
  const std::vector<std::uint8_t> text(64, 0x13);
  firmware.image.segments.push_back({tests::FakeChip::memory_start, text});
  firmware.image.constants.push_back({tests::FakeChip::memory_start, 64});
  const auto fill = [&firmware](std::uint32_t word) {
    for (std::uint32_t i = 0; i < 0x400; i += 4) {
      firmware.chip.write_memory(tests::FakeChip::memory_start + i, word);
    }
  };
  const auto load = [&firmware, &fill] {
    fill(0);
    for (std::uint32_t i = 0; i < 64; i += 4) {
      firmware.chip.write_memory(tests::FakeChip::memory_start + i, 0x1313'1313);
    }
  };
  report::FirmwareWatch watch(firmware.image, firmware.chip);
  std::size_t lines = 0, done = 0;
  watch.on_accepted = [&](sim::Clock, const AcceptedLine&) { ++lines; };
  watch.on_finished = [&](sim::Clock, bool) { ++done; };
  load();
  firmware.start();
  watch.wake(1000);
  for (const std::uint32_t word : {0x6Fu, 1u, 5u, 0xFFFF'FFFFu}) {
    fill(word);
    for (sim::Clock now = 2000; now < 100'000; now += 1000) ASSERT_NO_THROW(watch.wake(now));
  }
  EXPECT_EQ(lines, 0u);
  EXPECT_EQ(done, 0u);
  EXPECT_EQ(watch.other_programs(), 1u);
  EXPECT_FALSE(watch.firmware_is_in_memory());
  load();
  for (sim::Clock now = 100'000; now < 200'000; now += 1000) watch.wake(now);
  firmware.start();
  watch.wake(200'000);
  firmware.accept("M105", std::nullopt);
  watch.wake(201'000);
  EXPECT_EQ(lines, 1u);
}

// Words that contradict each other, written by a debugger or a wild store.
TEST(FirmwareWatch, outlives_words_that_cannot_be) {
  Firmware firmware;
  report::FirmwareWatch watch(firmware.image, firmware.chip);
  firmware.start();
  watch.wake(1000);
  firmware.set(12, 0xFFFF'FFF0);  // no memory
  firmware.set(3, 5);
  EXPECT_NO_THROW(watch.wake(2000));
  firmware.set(12, ring);
  firmware.set(1, 0xFFFF'FFFF);  // would be reported one by one
  firmware.set(3, 0x8000'0000);
  EXPECT_NO_THROW(watch.wake(3000));
  EXPECT_EQ(watch.gaps(), 3u);
  firmware.set(0, 1);  // a block with fewer words
  EXPECT_NO_THROW(watch.wake(4000));
}

TEST(FirmwareWatch, refuses_an_image_without_the_block) {
  Firmware firmware;
  firmware.image.symbols.clear();
  EXPECT_THROW(report::FirmwareWatch(firmware.image, firmware.chip), std::runtime_error);
}

TEST(AcceptLog, writes_bytes_that_are_no_text_as_numbers) {
  EXPECT_EQ(report::accept_log_row({std::nullopt, std::string("M1\x00\xfe", 4)}),
            "-\tM1\\x00\\xfe\n");
}

class Listener : public devices::HostListener {
 public:
  void command_sent(sim::Clock, std::size_t line, std::string_view command) override {
    events.push_back("sent " + std::to_string(line) + " " + std::string(command));
  }
  void command_acknowledged(sim::Clock, std::size_t line, std::string_view,
                            bool executed) override {
    events.push_back((executed ? "done " : "refused ") + std::to_string(line));
  }
  void reply(sim::Clock, std::string_view line) override {
    events.push_back("reply " + std::string(line));
  }
  std::vector<std::string> events;
};

TEST(ServedHost, reports_commands_one_after_the_other_although_more_are_accepted) {
  report::ServedHost host;
  Listener listener;
  host.add_listener(listener);
  host.accepted(1, {1, "G28 ; home"});
  host.accepted(1, {2, "G1 X5"});
  for (const char byte : std::string("echo:busy: processing\nok\n")) host.heard(2, byte);
  host.finished(2, true);
  host.finished(3, false);
  host.finished(4, true);
  EXPECT_THAT(listener.events, ElementsAre("sent 1 G28", "reply echo:busy: processing", "reply ok",
                                           "done 1", "sent 2 G1 X5", "refused 2"));
  EXPECT_EQ(host.counts().lines_sent, 2U);
  EXPECT_EQ(host.counts().commands_executed, 1U);
  EXPECT_EQ(host.counts().commands_refused, 1U);
  EXPECT_EQ(host.counts().busy_replies, 1U);
}

}  // namespace
