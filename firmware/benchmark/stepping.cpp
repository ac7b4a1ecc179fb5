// SPDX-License-Identifier: Apache-2.0
// The program behind `bench stepping`: gives the segments of its order to hardware or software
// stepping, and keeps the queue filled as the firmware does.
#include "benchmark/stepping.hpp"

#include <array>

#include "drivers/identity.hpp"
#include "drivers/step_generator.hpp"
#include "drivers/timer.hpp"
#include "drivers/uart.hpp"
#include "platform/fault.hpp"
#include "platform/processor.hpp"

extern "C" {
[[gnu::used]] constinit benchmark::SteppingOrder benchmark_order{};
[[gnu::used]] constinit benchmark::SteppingResult benchmark_result{};
}

namespace {

constexpr std::uint32_t wake_level_bytes = 32;

motion::Segment segment_of(const benchmark::Piece& piece, bool last) {
  motion::Segment segment;
  for (std::size_t axis = 0; axis < units::axis_count; ++axis) {
    segment.steps[axis] = piece.steps[axis];
  }
  segment.line_ticks = piece.line_ticks;
  segment.ticks = piece.ticks;
  segment.continues_line = piece.continues_line != 0;
  segment.ends_motion = last;
  segment.rate = std::uint64_t{piece.rate_high} << 32 | piece.rate_low;
  segment.acceleration = static_cast<std::int64_t>(std::uint64_t{piece.acceleration_high} << 32 |
                                                   piece.acceleration_low);
  return segment;
}

// Echoes received bytes. True if more may follow.
bool echo(drivers::Uart& uart) {
  std::array<char, 64> bytes;
  const std::size_t count = uart.read(bytes).count;
  static_cast<void>(uart.write({bytes.data(), count}));
  return count == bytes.size();
}

class Feeder {
 public:
  // Until the queue is full or all is handed over.
  void fill() {
    while (!done() && steps_.free_segments() > 0) {
      const benchmark::Piece& piece = benchmark_order.pieces[index_];
      const bool last_piece = index_ + 1 == benchmark_order.piece_count;
      const bool last = last_piece && repetition_ + 1 == benchmark_order.repetitions;
      if (!steps_.append(segment_of(piece, last))) ++benchmark_result.refused;
      index_ = last_piece ? 0 : index_ + 1;
      if (last_piece) ++repetition_;
    }
  }
  bool done() const { return repetition_ == benchmark_order.repetitions; }
  drivers::StepGenerator& steps() { return steps_; }

 private:
  drivers::StepGenerator steps_;
  std::uint32_t index_ = 0;
  std::uint32_t repetition_ = 0;
};

}  // namespace

int main() {
  const auto identity = drivers::read_identity();
  if (!identity) platform::halt("not a StepFabric chip");
  static drivers::Uart uart;
  static drivers::Timer timer;
  static Feeder feeder;
  const benchmark::SteppingOrder& order = benchmark_order;

  units::PerAxis<drivers::GuardTimings> guards;
  guards.fill({order.guard_high, order.guard_low, order.guard_setup, order.guard_hold});
  platform::wake_by(platform::WakeSource::timer, true);
  const bool talks = order.baud != 0;
  if (talks) {
    if (!uart.configure(order.baud, identity->clock)) platform::halt("no such baud rate");
    uart.interrupt_on({.receive_level = wake_level_bytes});
    platform::wake_by(platform::WakeSource::uart_receive, true);
  }
  // Full when motion begins.
  feeder.steps().configure(guards, 1);
  for (std::size_t axis = 0; axis < units::axis_count; ++axis) {
    feeder.steps().enable_motor(static_cast<units::Axis>(axis), true);
  }
  feeder.steps().permit_motion(false);
  feeder.fill();
  feeder.steps().permit_motion(true);
  while (!feeder.done() || !feeder.steps().idle()) {
    const units::Cycles now = timer.now();
    feeder.fill();
    if (talks && echo(uart)) continue;
    timer.set_deadline(now + units::Cycles(order.wake_clocks));
    platform::sleep();
  }
  const auto counters = feeder.steps().counters();
  benchmark_result.segments = counters.segments;
  benchmark_result.underruns = counters.underruns;
  benchmark_result.stall_clocks = counters.stall_clocks;
  benchmark_result.bytes_lost = talks ? uart.error_counts().overruns : 0;
  benchmark_result.done = 1;
  for (;;) platform::sleep();
}
