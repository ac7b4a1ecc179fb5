// SPDX-License-Identifier: Apache-2.0
// The loop over the bytes of a line, apart from the rest because it is compiled for speed.
#include <algorithm>

#include "host_link/line_receiver.hpp"
#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"

namespace host_link {
namespace {

constexpr bool is_mere_text(unsigned char c) {
  return static_cast<unsigned>(c - ' ') <= '~' - ' ' && c != '*';
}

}  // namespace

[[gnu::noinline]] std::size_t LineReceiver::put_text(std::span<const char> bytes) {
  if (star_seen_ || length_ >= max_line_length) return 0;
  const std::size_t most = std::min<std::size_t>(bytes.size(), max_line_length - length_);
  const char* here = bytes.data();
  const char* const end = here + most;
  char* to = buffer_.data() + length_;
  std::uint32_t exclusive_or = exclusive_or_;
  units::LoopBound<max_line_length> characters;
  while (here != end) {
    const auto byte = static_cast<unsigned char>(*here);
    if (!is_mere_text(byte)) break;
    characters.next();
    units::happens<units::Event::byte_taken>(byte);
    *to++ = static_cast<char>(byte);
    exclusive_or ^= byte;
    ++here;
  }
  const auto count = static_cast<std::size_t>(here - bytes.data());
  if (count != 0) after_carriage_return_ = false;
  exclusive_or_ = static_cast<std::uint8_t>(exclusive_or);
  length_ += static_cast<std::uint32_t>(count);
  return count;
}

}  // namespace host_link
