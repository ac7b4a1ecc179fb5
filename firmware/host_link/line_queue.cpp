// SPDX-License-Identifier: Apache-2.0
// A ring of line slots.
#include "host_link/line_queue.hpp"

#include <algorithm>

#include "host_link/line_number.hpp"
#include "units/loop_bound.hpp"

namespace host_link {

void LineQueue::put(const ReceivedLine& line, bool emergency) {
  const std::size_t place = (first_ + size_) % capacity;
  const auto bit = static_cast<std::uint8_t>(1u << place);
  set_numbering_ = static_cast<std::uint8_t>(set_numbering_ & ~bit);
  if (sets_numbering(line)) set_numbering_ |= bit;
  Slot& slot = slots_[place];
  const std::size_t length = std::min(line.text.size(), max_line_length);
  const char* from = line.text.data();
  char* to = slot.text.data();
  units::LoopBound<max_line_length> characters;
  for (const char* const end = from + length; from != end;) {
    characters.next();
    *to++ = *from++;
  }
  slot.length = static_cast<std::uint8_t>(length);
  slot.number = line.number.value_or(0);
  slot.numbered = line.number.has_value();
  slot.emergency = emergency;
  slot.withdrawn = false;
  ++size_;
}

AcceptedLine LineQueue::front() const {
  const Slot& slot = slots_[first_];
  return {{slot.text.data(), slot.length},
          slot.numbered ? std::optional(slot.number) : std::nullopt,
          slot.emergency};
}

void LineQueue::drop() {
  if (slots_[first_].withdrawn) --withdrawn_;
  first_ = (first_ + 1) % capacity;
  --size_;
}

std::size_t LineQueue::numbered_in_sequence() const {
  std::size_t count = 0;
  LineNumber next = 0;
  units::LoopBound<capacity> bound;
  for (std::size_t i = 0; i < size_; ++i) {
    bound.next();
    const std::size_t place = (first_ + i) % capacity;
    const Slot& line = slots_[place];
    if ((set_numbering_ >> place & 1u) != 0) return 0;
    if (!line.numbered) continue;
    if (line.emergency || line.withdrawn || (count != 0 && line.number != next)) return 0;
    next = line.number + 1;
    ++count;
  }
  return count;
}

void LineQueue::withdraw_numbered() {
  units::LoopBound<capacity> bound;
  for (std::size_t i = 0; i < size_; ++i) {
    bound.next();
    Slot& line = slots_[(first_ + i) % capacity];
    if (line.withdrawn || !line.numbered) continue;
    line.withdrawn = true;
    ++withdrawn_;
  }
}

}  // namespace host_link
