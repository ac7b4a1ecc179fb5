// SPDX-License-Identifier: Apache-2.0
// Links, walked and changed one by one.
#include "benchmark/linked_list.hpp"

#include "benchmark/checksum.hpp"

namespace benchmark {

void LinkedList::fill(std::uint32_t seed) {
  for (std::size_t i = 0; i < length; ++i) {
    seed = seed * 1'103'515'245u + 12'345u;
    records_[i] = {.value = static_cast<std::int16_t>(seed >> 16),
                   .place = static_cast<std::int16_t>(i)};
    links_[i] = {.next = i + 1 < length ? &links_[i + 1] : nullptr, .record = &records_[i]};
  }
  first_ = links_.data();
}

void LinkedList::reverse() {
  Link* reversed = nullptr;
  while (first_ != nullptr) {
    Link* const next = first_->next;
    first_->next = reversed;
    reversed = first_;
    first_ = next;
  }
  first_ = reversed;
}

int LinkedList::by_value(const Record& left, const Record& right) {
  return left.value - right.value;
}

int LinkedList::by_place(const Record& left, const Record& right) {
  return left.place - right.place;
}

void LinkedList::sort_by_value() { sort(by_value); }
void LinkedList::sort_by_place() { sort(by_place); }

// From runs of one on, each pass merges neighbours to runs of twice the length.
void LinkedList::sort(Comparison compare) {
  for (std::size_t run = 1; run < length; run *= 2) {
    Link* rest = first_;
    Link** end = &first_;
    while (rest != nullptr) {
      Link* left = rest;
      std::size_t left_count = 0;
      while (left_count < run && rest != nullptr) {
        rest = rest->next;
        ++left_count;
      }
      Link* right = rest;
      std::size_t right_count = run;
      while (left_count != 0 || (right_count != 0 && right != nullptr)) {
        const bool from_left = left_count != 0 && (right_count == 0 || right == nullptr ||
                                                   compare(*left->record, *right->record) <= 0);
        Link*& taken = from_left ? left : right;
        --(from_left ? left_count : right_count);
        *end = taken;
        end = &taken->next;
        taken = taken->next;
      }
      rest = right;
    }
    *end = nullptr;
  }
}

const LinkedList::Record* LinkedList::find(std::int16_t place) {
  Link* before = nullptr;
  for (Link* link = first_; link != nullptr; before = link, link = link->next) {
    if (link->record->place != place) continue;
    if (before != nullptr) {
      before->next = link->next;
      link->next = first_;
      first_ = link;
    }
    return link->record;
  }
  return nullptr;
}

std::uint16_t LinkedList::checksum() const {
  std::uint16_t sum = 0;
  for (const Link* link = first_; link != nullptr; link = link->next) {
    sum = add_half_word(sum, static_cast<std::uint16_t>(link->record->value));
  }
  return sum;
}

}  // namespace benchmark
