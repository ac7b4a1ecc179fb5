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
  for (const char byte : bytes) {
    received.next();
    units::happens<units::Event::byte_taken>(static_cast<unsigned char>(byte));
    if (!receiver_.put(byte)) continue;
    units::happens<units::Event::line_taken>();
    const ReceivedLine line = receiver_.take();
    std::string_view text = line.text;
    requested |= line.checksum != Checksum::wrong && !line.corrupted && !line.unprintable &&
                 take_m_code(text) == restart_code;
  }
  return requested;
}

}  // namespace host_link
