// SPDX-License-Identifier: Apache-2.0
// Bytes from and to the host, in a pass of the loop.
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "application/application.hpp"
#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"

namespace application {
namespace {

// An error and the request to send a line again, answers of two lines at most, and that it is busy.
constexpr std::uint32_t most_bytes_said = 320;

}  // namespace

// True if there were bytes of the host, or answers that were owed.
bool Application::exchange_bytes(const Now& now) {
  units::EventBound<units::Event::byte_queued, most_bytes_said> replies;
  units::EventBound<units::Event::character_written, host_link::TextLine::capacity> characters;
  // Nor is one given up within the time of the bytes that have ended another.
  units::EventBound<units::Event::line_taken, 1> line;
  const bool received = receive(now);
  link_.set_planner_space(static_cast<std::uint8_t>(motion_.room()));
  return link_.update(now.milliseconds, executor_.activity()) || received;
}

bool Application::receive(const Now& now) {
  units::EventBound<units::Event::byte_received, most_bytes> read;
  units::EventBound<units::Event::byte_taken, most_bytes> taken;
  std::array<char, most_bytes> bytes;
  const drivers::UartErrorCounts errors = hardware_.uart.error_counts();
  const auto [count, gap_before_last] = hardware_.uart.read_line(bytes);
  const bool emptied = count < most_bytes && !gap_before_last;
  if (hang_up_.seen(errors, gap_before_last, emptied, now.milliseconds)) link_.hang_up();
  if (count == 0) return false;
  units::happens<units::Event::received_or_executed>();
  std::span<const char> received(bytes.data(), count);
  if (gap_before_last && !hang_up_.explains(errors)) {
    link_.receive(received.first(count - 1), now.milliseconds);
    link_.receive_fault(now.milliseconds);
    received = received.last(1);
  }
  link_.receive(received, now.milliseconds);
  counters_.lines_accepted = link_.statistics().accepted;
  return true;
}

void Application::transmit() {
  units::EventBound<units::Event::byte_sent, host_link::TransmitQueue::capacity> bytes_sent;
  // The queue is a ring, whose bytes lie in two pieces at most.
  units::LoopBound<2> pieces;
  for (auto bytes = link_.to_send(); !bytes.empty(); bytes = link_.to_send()) {
    pieces.next();
    const std::size_t sent = hardware_.uart.write(bytes);
    link_.sent(sent);
    if (sent < bytes.size()) return;
  }
}

}  // namespace application
