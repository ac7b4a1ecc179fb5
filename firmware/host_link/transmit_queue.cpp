// SPDX-License-Identifier: Apache-2.0
// The byte ring of whole reply lines.
#include "host_link/transmit_queue.hpp"

#include <algorithm>

#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"

namespace host_link {
namespace {

// What is not printable becomes '?'. Without a branch, since any byte must take as long.
constexpr unsigned printable(unsigned c) {
  const unsigned other = c - ' ' > '~' - ' ' ? 1 : 0;
  return c ^ ((c ^ '?') & (0 - other));
}
static_assert(printable(' ') == ' ' && printable('~') == '~');
static_assert(printable('\x1f') == '?' && printable('\x7f') == '?' && printable(0xff) == '?');

}  // namespace

bool TransmitQueue::put_line(std::initializer_list<std::string_view> parts, std::size_t spare) {
  std::size_t length = 1;
  units::LoopBound<most_parts> counted;
  for (const std::string_view part : parts) {
    counted.next();
    length += part.size();
  }
  if (length + spare > room()) return false;
  std::size_t at = first_ + size_;
  size_ += length;
  units::LoopBound<most_parts, 1> copied;
  for (const std::string_view part : parts) {
    copied.next();
    if (part.empty()) continue;
    const char* from = part.data();
    const char* const end = from + part.size();
    units::LoopBound<capacity> characters;
    do {
      characters.next();
      const auto c = static_cast<unsigned char>(*from++);
      units::happens<units::Event::byte_queued>(reinterpret_cast<std::uintptr_t>(from));
      bytes_[at++ % capacity] = static_cast<char>(printable(c));
    } while (from != end);
  }
  bytes_[at % capacity] = '\n';
  return true;
}

std::span<const char> TransmitQueue::front() const {
  return {bytes_.data() + first_, std::min(size_, capacity - first_)};
}

void TransmitQueue::drop(std::size_t count) {
  first_ = (first_ + count) % capacity;
  size_ -= count;
}

}  // namespace host_link
