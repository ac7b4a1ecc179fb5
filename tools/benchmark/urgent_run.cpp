// SPDX-License-Identifier: Apache-2.0
// A host that prints with several lines in flight and sends queries now and then.
#include "tools/benchmark/urgent_run.hpp"

#include <fmt/format.h>

#include <random>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "tools/benchmark/cold_printer.hpp"

namespace benchmarks {

namespace {

constexpr std::size_t lines_between_questions = 10;
// A pass of the loop at 4 MHz and more.
constexpr double longest_pause_seconds = 0.04;
constexpr double patience_seconds = 5;
constexpr sim::Clock looks_clocks = 20'000;
constexpr double bits_until_heard = 9.5;  // of a byte, whose start bit is what counts

std::string framed(std::size_t number, std::string_view command) {
  const std::string text = fmt::format("N{} {}", number, command);
  unsigned checksum = 0;
  for (const char character : text) checksum ^= static_cast<unsigned char>(character);
  return fmt::format("{}*{}\n", text, checksum);
}

class Host : public sim::Device, public devices::ByteListener {
 public:
  Host(const UrgentOrder& order, devices::SerialLine& line)
      : order_(order), rate_(order.clock_hz), line_(line), random_(order.seed) {
    line_.set_listener(*this);
  }

  bool stopped() const { return stopped_at_ != 0; }
  sim::Clock last_sign() const { return last_sign_; }
  std::vector<double> answers_us() const { return answers_us_; }
  double stop_us() const { return us(stopped_at_ - sent_at_); }

  void pins_changed(sim::Clock now, sim::OutputPins pins, sim::OutputPins changed) override {
    if (asking_ && is_last_question() && changed.enable(0) && !pins.enable(0)) stopped_at_ = now;
  }

  void all_sent(sim::Clock now) override { sent_at_ = now; }

  void byte_received(sim::Clock now, std::uint8_t byte) override {
    last_sign_ = now;
    if (reply_.empty()) heard_from_ = now;
    if (byte != '\n') {
      reply_ += static_cast<char>(byte);
      return;
    }
    take(std::exchange(reply_, {}));
    go_on(now);
  }

  void wake(sim::Clock now) override {
    const std::string_view command = is_last_question() ? "M112" : "M105";
    line_.send(now, order_.numbered ? framed(number_++, command) : std::string(command) + "\n");
    pausing_ = false;
    asking_ = true;
  }

 private:
  double us(sim::Clock clocks) const { return 1e6 * rate_.seconds(clocks); }
  bool is_last_question() const { return answers_us_.size() == order_.questions; }

  void take(const std::string& reply) {
    if (reply == "start") greeted_ = true;
    if (reply.starts_with("ok T:")) {
      answers_us_.push_back(us(heard_from_ - sent_at_) - bits_until_heard * 1e6 / order_.baud);
      asking_ = false;
      since_question_ = 0;
    } else if (reply.starts_with("ok")) {
      ++answered_;
      ++since_question_;
    }
  }

  void go_on(sim::Clock now) {
    if (!greeted_ || asking_ || pausing_) return;
    if (since_question_ >= lines_between_questions) {
      pausing_ = true;
      const double pause =
          std::uniform_real_distribution<double>(0, longest_pause_seconds)(random_);
      next_wake_ = now + rate_.clocks(pause) + 1;
      return;
    }
    while (sent_ < order_.lines.size() && sent_ < answered_ + order_.in_flight) {
      line_.send(now, framed(number_++, order_.lines[sent_++]));
    }
  }

  const UrgentOrder& order_;
  sim::ClockRate rate_;
  devices::SerialLine& line_;
  std::mt19937_64 random_;
  std::string reply_;
  std::size_t number_ = 0, sent_ = 0, answered_ = 0, since_question_ = 0;
  bool greeted_ = false, pausing_ = false, asking_ = false;
  sim::Clock heard_from_ = 0, sent_at_ = 0, stopped_at_ = 0, last_sign_ = 0;
  std::vector<double> answers_us_;
};

}  // namespace

UrgentRun run_urgent(const sim::ElfImage& firmware, const machine::Description& description,
                     const UrgentOrder& order, const std::function<void()>& look) {
  ColdPrinter cold(firmware, description, order.clock_hz, order.baud);
  sim::Simulation& simulation = cold.simulation;
  const sim::ClockRate rate = simulation.rate();
  Host host(order, cold.printer.serial_line());
  simulation.attach(host, sim::OutputPins::motor_pins(0));
  while (!host.stopped()) {
    look();
    simulation.run_until(simulation.now() + looks_clocks);
    if (simulation.now() > host.last_sign() + rate.clocks(patience_seconds)) {
      throw std::runtime_error(
          fmt::format("no sign of the chip after question {}", host.answers_us().size()));
    }
  }
  return {.answers_us = host.answers_us(), .stop_us = host.stop_us()};
}

}  // namespace benchmarks
