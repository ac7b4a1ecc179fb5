// SPDX-License-Identifier: Apache-2.0
// A host that sends some lines, whatever the answers.
#include "tests/replay/recorded_run.hpp"

#include <random>
#include <string_view>

#include "sim/replay/interval_recorder.hpp"
#include "sim/simulation/verilated_chip.hpp"
#include "tests/loaded_printer.hpp"

namespace tests {

namespace {

constexpr std::string_view lines =
    "M110 N0\nM302 S0\nM104 S60\nM106 S77\nG92 X5 Y5 Z5\nG1 X7 Y5.5 F3000\nG1 X5 E1 F600\nM105\n";

class Host : public sim::Device {
 public:
  Host(devices::SerialLine& line, sim::InputPins& inputs) : line_(line), inputs_(inputs) {
    next_wake_ = recorded_clock_hz / 20;
  }

  void wake(sim::Clock now) override {
    if (!sent_) line_.send(now, lines);
    sent_ = true;
    // Of the axes' own switches none is among these.
    inputs_.end_stops = static_cast<std::uint8_t>((inputs_.end_stops & 0x0f) | (random_() & 0xf0));
    next_wake_ = now + 1 + random_() % 50'000;
  }

 private:
  devices::SerialLine& line_;
  sim::InputPins& inputs_;
  std::mt19937_64 random_{3};
  bool sent_ = false;
};

}  // namespace

std::vector<replay::Interval> recorded_run(sim::Clock clocks, sim::Clock length) {
  std::vector<replay::Interval> intervals;
  replay::IntervalRecorder recorder(
      length, [&](replay::Interval&& interval) { intervals.push_back(std::move(interval)); });
  sim::VerilatedChip chip(recorded_clock_hz);
  LoadedPrinter loaded(chip, recorded_clock_hz, 40.0, 30.0);
  chip.record(recorder);
  Host host(loaded.printer.serial_line(), chip.inputs());
  loaded.simulation.attach(host, {});
  loaded.simulation.run_until(clocks);
  recorder.finish(chip.now());
  return intervals;
}

}  // namespace tests
