// SPDX-License-Identifier: Apache-2.0
// The whole chip with its firmware on the simulated printer, and hosts of every kind at its serial
// line, in simulated time.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "sim/machine/printer.hpp"
#include "sim/report/firmware_watch.hpp"
#include "sim/simulation/elf_image.hpp"
#include "sim/simulation/verilated_chip.hpp"
#include "tests/host_link/eavesdropper.hpp"
#include "tests/host_link/host_models.hpp"
#include "tests/host_link/noisy_line.hpp"

namespace host_programs {

struct Edge {
  std::size_t axis;
  int direction;
  std::int64_t position;
  bool operator==(const Edge&) const = default;
};

// Records everything that a host and a person at the printer can observe.
class ServedChip : public devices::ByteListener, public devices::StepListener {
 public:
  // The heaters start at these temperatures.
  explicit ServedChip(double hotend_c = 22, double bed_c = 22);

  void run(double seconds) { simulation.run_until(simulation.now() + rate.clocks(seconds)); }
  // Bytes as they are, without waiting for anything.
  void send(const std::string& bytes) { printer->serial_line().send(simulation.now(), bytes); }
  // Runs until all bytes are on the wire.
  void finish_sending();
  // The next reply that is no busy message, within the time; empty where none comes.
  std::string reply(double seconds = 20);
  // Sends a numbered line and waits for its ok; what was said before the ok.
  std::vector<std::string> ask(int number, const std::string& text);
  // A fresh host: it connects as OctoPrint does, homes X and moves.
  void expect_that_a_fresh_host_prints();

  // Host model and noise on both ways; returns whether the host had everything acknowledged.
  bool converse(host_link::test::HostModel& host, double faults_per_byte, std::uint64_t seed,
                double patience_seconds, host_link::test::Eavesdropper& eavesdropper);
  // Between a line of the host and the next ok, resend or busy message, in seconds; the longest.
  double longest_wait() const { return longest_wait_; }

  void byte_received(sim::Clock now, std::uint8_t byte) override;
  void stepped(const devices::StepEdge& edge) override;

  static constexpr std::uint32_t clock_hz = 4'000'000;
  sim::ClockRate rate{clock_hz};
  sim::ElfImage firmware;
  sim::VerilatedChip chip{clock_hz};
  sim::Simulation simulation{chip, rate};
  std::unique_ptr<machine::Printer> printer;
  std::unique_ptr<report::FirmwareWatch> watch;
  std::vector<report::AcceptedLine> accepted;
  std::vector<Edge> edges;

 private:
  std::string bytes_;
  std::deque<std::string> replies_;
  host_link::test::NoisyLine* noise_ = nullptr;  // on the way to the host
  double waiting_since_ = -1;
  double longest_wait_ = 0;
};

}  // namespace host_programs
