// SPDX-License-Identifier: Apache-2.0
// The chip with its printer, a host with some lines in flight, and the clocks at
// which replies came.
#include "tools/benchmark/link_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "tools/benchmark/cold_printer.hpp"
#include "tools/benchmark/pin_watch.hpp"
#include "tools/benchmark/window_host.hpp"

namespace benchmarks {

namespace {

constexpr sim::Clock looks_clocks = 20'000;
// A line without an answer after this time is considered lost.
constexpr double patience_seconds = 5;
// A byte has been heard in the middle of its stop bit.
constexpr double bits_until_heard = 9.5;
constexpr int least_decimals = 3, most_decimals = 7;

double motion_seconds(const PinWatch& pins, sim::ClockRate rate) {
  sim::Clock first = sim::never, last = 0;
  for (std::size_t i = 0; i < axes; ++i) {
    if (pins.axis(i).rises.empty()) continue;
    first = std::min(first, pins.axis(i).rises.front());
    last = std::max(last, pins.axis(i).rises.back());
  }
  return first == sim::never ? 0 : rate.seconds(last - first);
}

}  // namespace

std::string NumberedLines::framed(const std::string& command) const {
  const std::string text = fmt::format("N{} {}", lines_.size(), command);
  unsigned checksum = 0;
  for (const char character : text) checksum ^= static_cast<unsigned char>(character);
  return fmt::format("{}*{}", text, checksum);
}

void NumberedLines::add_move(double x_mm, double y_mm, std::size_t length) {
  for (int x = least_decimals; x <= most_decimals; ++x) {
    for (int y = least_decimals; y <= most_decimals; ++y) {
      const std::string line = framed(fmt::format("G1 X{:.{}f} Y{:.{}f}", x_mm, x, y_mm, y));
      if (line.size() != length) continue;
      lines_.push_back(line);
      return;
    }
  }
  throw std::runtime_error(
      fmt::format("no line of {} characters goes to X{} Y{}", length, x_mm, y_mm));
}

LinkRun run_link(const sim::ElfImage& firmware, const machine::Description& description,
                 const LinkOrder& order, const std::function<void()>& look) {
  ColdPrinter cold(firmware, description, order.clock_hz, order.baud, order.hotend_c);
  sim::Simulation& simulation = cold.simulation;
  const sim::ClockRate rate = simulation.rate();
  PinWatch pins;
  simulation.attach(pins, PinWatch::watched());
  WindowHost host(order.lines, cold.printer.serial_line(), order.window);

  // The counters are sampled less often than lines come: counts between two samples are attributed
  // to whole lines.
  sim::Clock measured_from = 0, awake_from = 0;
  sim::Clock last_answer = 0;
  std::size_t answered = 0;
  const auto awake = [&] {
    return simulation.now() - cold.chip.processor_statistics().sleeping_clocks;
  };
  LinkRun run;
  const auto sample = [&](sim::Clock end) {
    std::uint64_t slept = cold.chip.processor_statistics().sleeping_clocks;
    while (simulation.now() < end) {
      simulation.run_until(std::min(end, simulation.now() + order.sample_clocks));
      const sim::ProcessorStatistics statistics = cold.chip.processor_statistics();
      if (statistics.sleeping_clocks == slept) ++run.samples[statistics.program_counter];
      slept = statistics.sleeping_clocks;
    }
  };
  while (!host.done()) {
    look();
    const sim::Clock end = simulation.now() + looks_clocks;
    if (measured_from != 0 && order.sample_clocks != 0) sample(end);
    simulation.run_until(end);
    if (!host.complaint().empty()) {
      throw std::runtime_error(fmt::format("a line was refused: {}", host.complaint()));
    }
    if (measured_from == 0 && host.answers().size() > order.first_measured) {
      measured_from = simulation.now();
      awake_from = awake();
    }
    if (host.answers().size() != answered) last_answer = simulation.now();
    answered = host.answers().size();
    if (simulation.now() - last_answer > rate.clocks(patience_seconds)) {
      throw std::runtime_error(fmt::format("line {} is not answered", answered));
    }
  }

  const auto& answers = host.answers();
  run.busy_percent = 100.0 * static_cast<double>(awake() - awake_from) /
                     static_cast<double>(simulation.now() - measured_from);
  run.lines_per_second = static_cast<double>(answers.size() - 1 - order.first_measured) /
                         rate.seconds(answers.back().heard - answers[order.first_measured].heard);
  // In whole clocks, so that rounding leaves no mean above the longest.
  sim::Clock sum = 0, longest = 0;
  for (std::size_t i = order.first_measured; i < answers.size(); ++i) {
    const sim::Clock latency = answers[i].heard_from - answers[i].sent;
    sum += latency;
    longest = std::max(longest, latency);
  }
  const auto latency_us = [&](double clocks) {
    return 1e6 * (clocks / order.clock_hz - bits_until_heard / order.baud);
  };
  run.mean_latency_us = latency_us(static_cast<double>(sum) /
                                   static_cast<double>(answers.size() - order.first_measured));
  run.longest_latency_us = latency_us(static_cast<double>(longest));
  run.motion_seconds = motion_seconds(pins, rate);
  run.underruns = cold.chip.queue_statistics().underruns;
  return run;
}

}  // namespace benchmarks
