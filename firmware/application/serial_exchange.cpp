// SPDX-License-Identifier: Apache-2.0
// Bytes from and to the host, in a pass of the loop and between the lines that it hands over.
#include <algorithm>
#include <array>
#include <span>

#include "application/application.hpp"
#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"

namespace application {
namespace {

constexpr std::size_t bytes_of_a_line = 32;

}  // namespace

void Application::exchange_bytes(Now now, std::size_t most) {
  // None leaves the queue meanwhile.
  using Queue = host_link::TransmitQueue;
  units::EventBound<units::Event::byte_queued, Queue::capacity> replies;
  units::EventBound<units::Event::ok_repaid, host_link::HostLink::most_oks> oks;
  receive(now, most);
  link_.set_planner_space(static_cast<std::uint8_t>(motion_.room()));
  link_.update(now.milliseconds, executor_.activity());
}

void Application::receive(Now now, std::size_t most) {
  units::EventBound<units::Event::byte_received, most_bytes> read;
  units::EventBound<units::Event::byte_taken, most_bytes> taken;
  std::array<char, most_bytes> bytes;
  const drivers::UartErrorCounts errors = hardware_.uart.error_counts();
  const auto [count, gap_before_last] = hardware_.uart.read(std::span(bytes).first(most));
  const bool emptied = count < most && !gap_before_last;
  if (hang_up_.seen(errors, gap_before_last, emptied, now.milliseconds)) link_.hang_up();
  if (count == 0) return;
  std::span<const char> received(bytes.data(), count);
  if (gap_before_last && !hang_up_.explains(errors)) {
    link_.receive(received.first(count - 1), now.milliseconds);
    link_.receive_fault(now.milliseconds);
    received = received.last(1);
  }
  link_.receive(received, now.milliseconds);
  counters_.lines_accepted = link_.statistics().accepted;
}

// Between lines, and after the last, a stop is executed, and a query answered if it is next:
// the planner, full, has many for a start from rest. True if something has come that may have to
// be executed, or if there are more lines.
bool Application::refill() {
  bool come = false;
  bool more = true;
  units::LoopBound<MotionTask::most_refills> handed_over;
  const unsigned most = motion_.refills_in_a_pass();
  for (unsigned lines = 1; more && !halted_ && lines <= most; ++lines) {
    handed_over.next();
    more = motion_.refill();
    if ((more && lines < task_timing::lines_without_look) || !hardware_.uart.line_waits()) continue;
    come = true;
    const Now now = clock_.update(hardware_.timer.now());
    {
      units::EventBound<units::Event::byte_received, bytes_of_a_line> read;
      units::EventBound<units::Event::byte_taken, bytes_of_a_line> taken;
      exchange_bytes(now, bytes_of_a_line);
    }
    act_on_emergencies();
    if (!halted_) executor_.answer_questions(now);
    transmit();
  }
  return come || more;
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
