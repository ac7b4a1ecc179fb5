// SPDX-License-Identifier: Apache-2.0
// Sets up the chip, and sends and receives on its serial line.
#include "tests/host_programs/served_chip.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "tests/host_link/dialogue.hpp"
#include "tests/loaded_printer.hpp"

namespace host_programs {
namespace {

constexpr double start_up_seconds = 0.05;
constexpr double millisecond = 0.001;
// The planner holds up to 16 lines that are acknowledged and not yet made.
constexpr double planned_motion_seconds = 4.0;

bool is_sign_of_life(const std::string& line) {
  return line.starts_with("ok") || line.starts_with("Resend") || line.starts_with("echo:busy");
}

}  // namespace

ServedChip::ServedChip(double hotend_c, double bed_c)
    : firmware(sim::read_elf(tests::firmware_file)) {
  sim::load(firmware, chip);
  const machine::Description description = tests::default_machine();
  const machine::PrinterOptions options{.baud = description.baud,
                                        .seed = 1,
                                        .hotend_start_c = hotend_c,
                                        .bed_start_c = bed_c,
                                        .faults = {}};
  printer = std::make_unique<machine::Printer>(description, options, simulation);
  printer->add_step_listener(*this);
  printer->serial_line().set_listener(*this);
  watch = std::make_unique<report::FirmwareWatch>(firmware, chip);
  watch->on_accepted = [this](sim::Clock, const report::AcceptedLine& line) {
    accepted.push_back(line);
  };
  simulation.attach(*watch, {});
  EXPECT_EQ(reply(), "start");
  run(start_up_seconds);
}

void ServedChip::stepped(const devices::StepEdge& edge) {
  edges.push_back({edge.axis, edge.direction, edge.position});
}

void ServedChip::byte_received(sim::Clock now, std::uint8_t byte) {
  if (noise_ != nullptr) {
    const char character = static_cast<char>(byte);
    noise_->send({&character, 1});
  }
  if (byte != '\n') {
    bytes_ += static_cast<char>(byte);
    return;
  }
  const std::string line = std::exchange(bytes_, {});
  if (is_sign_of_life(line)) {
    if (waiting_since_ >= 0) {
      longest_wait_ = std::max(longest_wait_, rate.seconds(now) - waiting_since_);
    }
    waiting_since_ = line.starts_with("echo:busy") ? rate.seconds(now) : -1;
  }
  if (!line.starts_with("echo:busy")) replies_.push_back(line);
}

void ServedChip::finish_sending() {
  while (printer->serial_line().waiting_bytes() != 0) run(millisecond);
  run(millisecond);
}

std::string ServedChip::reply(double seconds) {
  const double end = simulation.seconds() + seconds;
  while (replies_.empty() && simulation.seconds() < end) run(millisecond);
  if (replies_.empty()) return {};
  std::string line = std::move(replies_.front());
  replies_.pop_front();
  return line;
}

std::vector<std::string> ServedChip::ask(int number, const std::string& text) {
  send(with_checksum("N" + std::to_string(number) + " " + text + "*?") + "\n");
  std::vector<std::string> said;
  for (;;) {
    std::string line = reply(60);
    if (line.empty() || line.starts_with("ok")) {
      EXPECT_FALSE(line.empty()) << "no ok to " << text;
      said.push_back(std::move(line));
      return said;
    }
    said.push_back(std::move(line));
  }
}

void ServedChip::expect_that_a_fresh_host_prints() {
  // A host waits before it is started, and throws away what it has not requested.
  run(2.5);
  replies_.clear();
  send("\nM105\n");
  run(0.5);
  const bool answered = std::ranges::any_of(
      replies_, [](const std::string& line) { return line.starts_with("ok T:"); });
  EXPECT_TRUE(answered) << "no temperatures after " << accepted.size() << " lines";
  replies_.clear();
  accepted.clear();
  ask(0, "M110 N0");
  ask(1, "G28 X");
  ask(2, "G1 X5 F3000");
  ask(3, "M400");
  ASSERT_EQ(accepted.size(), 4u);
  EXPECT_EQ(accepted[3].number, 3);
  EXPECT_NEAR(printer->axis(0).position_mm(), 5.0, 0.01);
}

bool ServedChip::converse(host_link::test::HostModel& host, double faults_per_byte,
                          std::uint64_t seed, double patience_seconds,
                          host_link::test::Eavesdropper& eavesdropper) {
  host_link::test::NoisyLine down(faults_per_byte, seed);
  host_link::test::NoisyLine up(faults_per_byte, seed + 1000);
  noise_ = &up;
  std::string reply;
  const double end = simulation.seconds() + patience_seconds;
  for (long now = 0; simulation.seconds() < end && !(host.done() && down.idle()); ++now) {
    const std::string text = host.speak(now);
    if (!text.empty() && waiting_since_ < 0) waiting_since_ = simulation.seconds();
    down.send(text);
    const std::string arrived = down.arrive_in_a_millisecond();
    eavesdropper.hear(arrived);
    send(arrived);
    run(millisecond);
    for (const char c : up.arrive_in_a_millisecond()) {
      if (c != '\n') {
        reply += c;
        continue;
      }
      host.hear(reply, now);
      reply.clear();
    }
  }
  run(planned_motion_seconds);  // the last lines are carried out
  noise_ = nullptr;
  replies_.clear();
  waiting_since_ = -1;
  return host.done();
}

}  // namespace host_programs
