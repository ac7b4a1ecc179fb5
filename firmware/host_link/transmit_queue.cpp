// SPDX-License-Identifier: Apache-2.0
// The byte ring of whole reply lines.
#include "host_link/transmit_queue.hpp"

#include <algorithm>

#include "units/event_bound.hpp"
#include "units/loop_bound.hpp"

namespace host_link {

bool TransmitQueue::put_line(std::initializer_list<std::string_view> parts, std::size_t spare) {
  std::size_t length = 1;
  units::LoopBound<most_parts> counted;
  for (const std::string_view part : parts) {
    counted.next();
    length += part.size();
  }
  if (length + spare > room()) return false;
  units::EventBound<units::Event::byte_queued, capacity> fits;
  units::LoopBound<most_parts, 1> copied;
  for (const std::string_view part : parts) {
    copied.next();
    units::LoopBound<capacity> characters;
    for (const char c : part) {
      characters.next();
      put(c >= ' ' && c <= '~' ? c : '?');
    }
  }
  put('\n');
  return true;
}

std::span<const char> TransmitQueue::front() const {
  return {bytes_.data() + first_, std::min(size_, capacity - first_)};
}

void TransmitQueue::drop(std::size_t count) {
  first_ = (first_ + count) % capacity;
  size_ -= count;
}

void TransmitQueue::put(char c) {
  bytes_[(first_ + size_) % capacity] = c;
  ++size_;
  units::happens<units::Event::byte_queued>(size_);
}

}  // namespace host_link
