// SPDX-License-Identifier: Apache-2.0
// A ring of line slots.
#include "host_link/line_queue.hpp"

#include <algorithm>

namespace host_link {

void LineQueue::put(std::string_view text, std::optional<LineNumber> number, bool emergency) {
  Slot& slot = slots_[(first_ + size_) % capacity];
  const std::size_t length = std::min(text.size(), max_line_length);
  std::copy_n(text.data(), length, slot.text.data());
  slot.length = static_cast<std::uint8_t>(length);
  slot.number = number.value_or(0);
  slot.numbered = number.has_value();
  slot.emergency = emergency;
  ++size_;
}

AcceptedLine LineQueue::front() const {
  const Slot& slot = slots_[first_];
  return {{slot.text.data(), slot.length},
          slot.numbered ? std::optional(slot.number) : std::nullopt,
          slot.emergency};
}

void LineQueue::drop() {
  first_ = (first_ + 1) % capacity;
  --size_;
}

}  // namespace host_link
