// SPDX-License-Identifier: Apache-2.0
// A file host that prints to a chip which says what each test lets it say.
#pragma once

#include <gmock/gmock.h>

#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/devices/file_host.hpp"
#include "sim/simulation/simulation.hpp"
#include "tests/sim/fake_chip.hpp"

namespace tests {

class FileHostTest : public testing::Test, public devices::HostListener {
 protected:
  static constexpr sim::ClockRate rate{4'000'000};

  // Prints the text; the chip answers each line with the next of `answers`, then with ok.
  void print(const std::string& gcode, std::deque<std::string> answers = {}, double seconds = 60,
             bool says_start = true) {
    const auto commands = devices::parse_gcode_text(gcode, "test");
    ASSERT_TRUE(commands);
    options.note = [this](const std::string& note) { notes.push_back(note); };
    host.emplace(*commands, line, rate, options);
    host->add_listener(*this);
    simulation.attach(*host, {});
    chip.firmware = [this, answers](const std::string& text) mutable {
      sent.push_back(text);
      if (answers.empty()) return std::string("ok\n");
      const std::string answer = answers.front();
      answers.pop_front();
      return answer;
    };
    if (says_start) chip.say("start\n");
    simulation.run_until(rate.clocks(seconds));
  }

  void command_acknowledged(sim::Clock, std::size_t file_line, std::string_view,
                            bool executed) override {
    acknowledged.emplace_back(file_line, executed);
  }

  void reply(sim::Clock now, std::string_view) override { replies_at.push_back(now); }

  FakeChip chip;
  sim::Simulation simulation{chip, rate};
  devices::SerialLine line{rate, 250'000, chip.inputs()};
  std::optional<devices::FileHost> host;
  devices::HostOptions options;
  std::vector<std::string> notes;
  std::vector<std::string> sent;
  std::vector<std::pair<std::size_t, bool>> acknowledged;
  std::vector<sim::Clock> replies_at;

  FileHostTest() { simulation.attach(line, sim::OutputPins::transmit_pin()); }
};

}  // namespace tests
