// SPDX-License-Identifier: Apache-2.0
// Floods, a silent reader and random bytes have no lasting effect on the link.
#include <gtest/gtest.h>

#include <random>
#include <span>
#include <string>

#include "host_link/host_link.hpp"

namespace host_link {
namespace {

class Link : public testing::Test {
 protected:
  void hear(const std::string& bytes) {
    for (std::span rest(bytes); !rest.empty();) {
      const std::size_t count = std::min(rest.size(), HostLink::most_bytes);
      link_.receive(rest.first(count), now_);
      rest = rest.subspan(count);
    }
  }

  void pass(std::int64_t milliseconds) {
    for (std::int64_t i = 0; i < milliseconds; ++i) {
      now_ += units::Milliseconds(1);
      link_.update(now_, Activity::idle);
    }
  }

  std::string read() {
    std::string text;
    link_.update(now_, Activity::idle);
    for (auto bytes = link_.to_send(); !bytes.empty(); bytes = link_.to_send()) {
      text.append(bytes.data(), bytes.size());
      link_.sent(bytes.size());
    }
    return text;
  }

  void work_off() {
    for (int i = 0; i < 100; ++i) {
      do {
        while (!link_.finished()) read();
      } while (link_.next_line());
      pass(100);
      read();
    }
  }

  // A fresh host gets its hello and its first line through.
  void expect_a_fresh_host_is_served() {
    pass(12'000);
    read();
    hear("\nM105\n");
    work_off();
    hear("N0 M110 N0*125\n");
    const auto hello = link_.next_line();
    ASSERT_TRUE(hello.has_value());
    EXPECT_EQ(hello->text, "M110 N0");
    EXPECT_TRUE(link_.finished());
    EXPECT_EQ(read(), "ok\n");
    hear("N1 G28*18\n");
    const auto line = link_.next_line();
    ASSERT_TRUE(line.has_value());
    EXPECT_EQ(line->text, "G28");
    EXPECT_TRUE(link_.finished());
    EXPECT_EQ(read(), "ok\n");
  }

  HostLink link_;
  units::Milliseconds now_{5000};
};

TEST_F(Link, survives_a_flood_without_waiting) {
  for (int i = 0; i < 50'000; ++i) hear("G1 X10 Y10 F3000\n");
  EXPECT_EQ(link_.statistics().accepted, LineQueue::capacity);
  work_off();
  expect_a_fresh_host_is_served();
}

TEST_F(Link, survives_a_line_of_64_kib) {
  hear(std::string(65'536, 'X'));
  hear("\n");
  EXPECT_EQ(read(), "echo:Line too long, not executed\nok\n");
  expect_a_fresh_host_is_served();
}

TEST_F(Link, survives_random_bytes) {
  std::mt19937_64 random(7);
  for (int round = 0; round < 20'000; ++round) {
    std::string bytes(random() % 24, '\0');
    for (char& c : bytes) c = random() % 20 == 0 ? '\n' : static_cast<char>(random());
    hear(bytes);
    pass(1);
    for (const char c : read()) ASSERT_TRUE(c == '\n' || (c >= ' ' && c <= '~'));
    if (link_.next_line() && random() % 2 == 0) link_.finished();
  }
  hear("\n");
  work_off();
  while (link_.emergency()) {
  }
  expect_a_fresh_host_is_served();
}

TEST_F(Link, refuses_lines_without_room_but_keeps_its_own_answers) {
  std::size_t said = 0;
  while (link_.say("echo:0123456789")) ++said;
  EXPECT_GT(said, 20u);
  hear("M105\n");
  ASSERT_TRUE(link_.next_line().has_value());
  // The room that is kept free suffices for an ok, though not for any report.
  EXPECT_FALSE(link_.finished(std::string(120, 'T')));
  EXPECT_TRUE(link_.finished(" T:20.00 /0.00"));
  const std::string sent = read();
  EXPECT_TRUE(sent.ends_with("\nok T:20.00 /0.00\n"));
}

TEST_F(Link, keeps_answers_for_a_reader_that_sleeps) {
  while (link_.say("echo:0123456789")) {
  }
  for (int i = 0; i < 100; ++i) hear(";\n");
  std::string sent;
  for (int i = 0; i < 50; ++i) {
    sent += read();
    pass(1);
  }
  std::size_t oks = 0;
  for (std::size_t at = sent.find("ok\n"); at != std::string::npos;
       at = sent.find("ok\n", at + 1)) {
    ++oks;
  }
  EXPECT_EQ(oks, 100u);
}

TEST_F(Link, does_not_run_a_line_that_the_uart_found_damaged) {
  hear("M10");
  link_.receive_fault(now_);
  hear("5\n");
  EXPECT_FALSE(link_.next_line().has_value());
  EXPECT_EQ(read(), "echo:Line damaged on the serial line, not executed\nok\n");
  hear("N1 G2");
  link_.receive_fault(now_);
  hear("8*18\n");
  EXPECT_FALSE(link_.next_line().has_value());
  EXPECT_EQ(read(), "echo:serial line disturbed, asked for again\nResend: 1\nok\n");
}

// An old half line is given up there, and the damage is that of the line after it, whose XOR
// is right.
TEST_F(Link, does_not_run_a_damaged_line_behind_an_old_half_line) {
  hear("G1 X1");
  pass(2500);
  link_.receive_fault(now_);
  hear("0*48\n");
  EXPECT_FALSE(link_.next_line().has_value());
  EXPECT_TRUE(read().contains("serial line disturbed, asked for again"));
}

}  // namespace
}  // namespace host_link
