// SPDX-License-Identifier: Apache-2.0
// The firmware's end of the serial conversation: bytes, faults and pauses as the input says; then a
// host that starts over gets its lines through.
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "tests/fuzz/link_model.hpp"

namespace {

constexpr std::array<int, 16> pauses_ms{0,   1,   2,   5,    10,   50,   100,  200,
                                        299, 300, 500, 1000, 1999, 2000, 3000, 10'000};

void act(fuzz::LinkModel& link, std::uint8_t action) {
  using host_link::Activity;
  constexpr std::array activities{Activity::idle, Activity::processing, Activity::paused_for_user,
                                  Activity::paused_for_input};
  if (action < 0x90) return link.pause(pauses_ms[action & 15]);
  if (action < 0x98) return link.finish_lines(1 + (action & 7U));
  switch (action) {
    case 0x98:
      return link.take_line();
    case 0x99:
      return link.disturb();
    case 0x9A:
      return link.begin_numbered(link.next_number());
    case 0x9B:
      return link.begin_numbered(link.requested_number());
    case 0x9C:
      return link.end_framed(0);
    case 0x9D:
      return link.end_framed(1);
    case 0x9E:
      return link.hear(16);
    case 0x9F:
      return link.hear(10'000);
    case 0xA4:
      return link.answer_query();
    case 0xA5:
      return link.say("echo:hi");
    default:
      break;
  }
  if (action < 0xA4) return link.work_on(activities[action & 3]);
  if (action >= 0xB0 && action < 0xC0) {
    link.begin_numbered(link.next_number());
    for (const char c : fmt::format("G1 X{}", action)) link.put(c);
    return link.end_framed(0);
  }
  link.put(static_cast<char>(action));
}

// Longer ones find nothing more and are slow.
constexpr std::size_t most_bytes = 600;

}  // namespace

// Bytes of ASCII go over the line as they are, the others say what else happens.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  size = std::min(size, most_bytes);
  fuzz::LinkModel link;
  for (std::size_t i = 0; i < size; ++i) {
    if (data[i] < 0x80) {
      link.put(static_cast<char>(data[i]));
    } else {
      act(link, data[i]);
    }
    link.check();
  }
  link.require_that_a_new_host_is_served();
  return 0;
}
