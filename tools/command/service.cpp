// SPDX-License-Identifier: Apache-2.0
// Keeps host, chip and real time in step, and reports to the user.
#include "tools/command/service.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "tools/command/output.hpp"
#include "tools/command/signals.hpp"

namespace command {

namespace {

constexpr double chunk_seconds = 0.005;
// Typical of PLA, for a warm start.
constexpr StartTemperatures warm_start{.hotend_c = 200.0, .bed_c = 57.0};
// A model slower than this for this long is reported.
constexpr double slow_ratio = 0.9;
constexpr double slow_seconds = 10.0;
constexpr double longest_start_seconds = 1.0;

}  // namespace

Service::Service(const ServeOptions& options)
    : options_(options),
      setup_(options.printer, warm_start),
      simulation_(setup_.simulation()),
      terminal_(options.terminal, setup_.printer().serial_line(), simulation_.rate(),
                setup_.baud()),
      watch_(setup_.firmware(), setup_.chip()),
      recorder_(command::opened(
          [&] { return report::Recorder(setup_.printer(), host_, simulation_, options.edges); })),
      pacer_(options.real_time) {
  if (!options.printer.accept_log.empty()) {
    command::opened([&] { accept_log_.emplace(options.printer.accept_log); });
  }
  listen();
  hold_back();
  simulation_.attach(terminal_, {}, sim::Activity::host_and_report);
  simulation_.attach(watch_, {}, sim::Activity::host_and_report);
}

void Service::run() {
  const sim::ClockRate rate = simulation_.rate();
  const sim::Clock chunk = rate.clocks(chunk_seconds);
  const sim::Clock until =
      options_.until_seconds ? rate.clocks(*options_.until_seconds) : sim::never;
  while (!interrupt_requested() && simulation_.now() < until) {
    simulation_.run_until(std::min(simulation_.now() + chunk, until));
    if (reset_wanted_) reset();
    if (simulation_.seconds() - held_since_ > longest_start_seconds) terminal_.hold_back(false);
    if (progress_.due()) show_status();
    pacer_.keep(simulation_.seconds());
  }
  progress_.finish();
}

report::Results Service::results() {
  host_.set_resends(watch_.resends());
  report::Results results = recorder_.results(setup_.firmware());
  results.outcome = report::Outcome::stopped;
  results.other_programs = watch_.other_programs();
  results.gaps = watch_.gaps();
  results.wall_seconds = pacer_.wall_seconds();
  return results;
}

std::string Service::close_files() {
  std::string complaint;
  try {
    recorder_.close_edges();
  } catch (const std::runtime_error& error) {
    complaint = error.what();
  }
  try {
    if (accept_log_) accept_log_->close();
  } catch (const std::runtime_error& error) {
    complaint = error.what();
  }
  return complaint;
}

void Service::greet(const std::filesystem::path& page) {
  command::say(
      "serving {} on {} ({}), {} baud, chip at {:.3g} MHz{}.\n"
      "  Pronterface, pronsole:  connect {} {}\n"
      "  OctoPrint:              additional serial port {}, {} baud\n"
      "Ctrl-C ends it and writes {}.\n",
      setup_.printer().description().name, options_.terminal.string(), terminal_.slave_path(),
      setup_.baud(), simulation_.rate().hertz() * 1e-6,
      options_.real_time ? ", in real time" : ", as fast as it goes", options_.terminal.string(),
      setup_.baud(), options_.terminal.string(), setup_.baud(), page.string());
  std::fflush(stdout);
}

void Service::listen() {
  terminal_.on_open = [this](sim::Clock) { opened(); };
  terminal_.on_close = [this](sim::Clock) { say("the host has closed the port"); };
  terminal_.on_byte = [this](sim::Clock now, char byte) {
    host_.heard(now, byte);
    if (byte == '\n' && !reset_wanted_) {
      terminal_.hold_back(false);  // it has greeted
    }
  };
  watch_.on_accepted = [this](sim::Clock now, const report::AcceptedLine& line) {
    host_.accepted(now, line);
    if (accept_log_) accept_log_->put(line);
  };
  watch_.on_program = [this](sim::Clock, bool firmware) {
    firmware_is_there_ = firmware;
    host_.start_over();
    say(firmware ? "the firmware is in the chip again"
                 : "another program is loaded: which lines it takes is not known");
  };
  watch_.on_withdrawn = [this](sim::Clock now) { host_.withdrawn(now); };
  watch_.on_finished = [this](sim::Clock now, bool executed) { host_.finished(now, executed); };
}

void Service::opened() {
  say("a host has opened the port");
  reset_wanted_ = options_.reset_on_open;
  if (reset_wanted_) {
    hold_back();
    simulation_.stop();
  }
}

void Service::hold_back() {
  terminal_.hold_back(true);
  held_since_ = simulation_.seconds();
}

void Service::reset() {
  reset_wanted_ = false;
  setup_.chip().reset();
  sim::load(setup_.firmware(), setup_.chip());
  setup_.set_speed_of_line();
  watch_.start_over();
  host_.start_over();
}

void Service::say(const std::string& text) {
  progress_.finish();
  say_to(stderr, "{:8.1f} s  {}\n", simulation_.seconds(), text);
}

void Service::show_status() {
  machine::Printer& printer = setup_.printer();
  const double wall = pacer_.wall_seconds();
  const double seconds = simulation_.seconds();
  const double wall_passed = std::max(wall - shown_wall_, 1e-9);
  const double ratio = (seconds - shown_seconds_) / wall_passed;
  const std::uint64_t lines = host_.counts().lines_sent;
  progress_.show_text(fmt::format(
      "{:8.1f} s  X{:7.2f} Y{:7.2f} Z{:6.2f}  hotend {:5.1f} °C  bed {:5.1f} °C  {:5.1f} lines/s"
      "  {:4.2f} of real time  {}",
      seconds, printer.place_mm()[0], printer.place_mm()[1], printer.place_mm()[2],
      printer.hotend_c(), printer.bed_c(), static_cast<double>(lines - shown_lines_) / wall_passed,
      ratio, connection()));
  shown_wall_ = wall;
  shown_seconds_ = seconds;
  shown_lines_ = lines;
  recorder_.flush_edges();
  complain_if_disk_is_full();
  complain_if_slow(ratio, wall_passed);
}

std::string Service::connection() const {
  if (!terminal_.connected()) return "no host";
  if (terminal_.host_baud() != setup_.baud()) {
    return fmt::format("the host is at {} baud, not {}!", terminal_.host_baud(), setup_.baud());
  }
  return firmware_is_there_ ? "connected" : "connected to another program";
}

void Service::complain_if_disk_is_full() {
  if (disk_is_full_ || !(recorder_.edges_failed() || (accept_log_ && accept_log_->failed()))) {
    return;
  }
  disk_is_full_ = true;
  say("cannot write the edges or the accepted lines any more");
}

void Service::complain_if_slow(double ratio, double seconds) {
  slow_for_ = ratio < slow_ratio ? slow_for_ + seconds : 0;
  if (!options_.real_time || complained_ || slow_for_ < slow_seconds) return;
  complained_ = true;
  say(fmt::format(
      "this machine simulates {:.2f} million clocks/s: with --clock-hz {} the printer "
      "would keep up with real time",
      ratio * simulation_.rate().hertz() * 1e-6,
      std::max(
          lowest_serve_clock_hz,
          static_cast<std::uint32_t>(ratio * simulation_.rate().hertz()) / 100'000 * 100'000)));
}

}  // namespace command
