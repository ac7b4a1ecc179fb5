// SPDX-License-Identifier: Apache-2.0
// What the link still listens to after a fault.
#include "host_link/host_link.hpp"
#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"

namespace host_link {

bool HostLink::restart_requested(std::span<const char> bytes) {
  constexpr std::uint32_t restart_code = 999;
  bool requested = false;
  units::LoopBound<most_bytes> received;
  while (!bytes.empty()) {
    received.next();
    const auto [count, line_ended] = receiver_.put(bytes);
    bytes = bytes.subspan(count);
    if (!line_ended) break;
    const ReceivedLine line = receiver_.take();
    requested |= line.checksum != Checksum::wrong && !line.corrupted && !line.unprintable &&
                 line.m_code == restart_code;
  }
  return requested;
}

}  // namespace host_link
