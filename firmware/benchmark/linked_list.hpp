// SPDX-License-Identifier: Apache-2.0
// A list of small records: searched, reversed and sorted by moving links only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace benchmark {

class LinkedList {
 public:
  static constexpr std::size_t length = 40;

  struct Record {
    std::int16_t value{};
    std::int16_t place{};  // in the order of making
  };

  // Values that only depend on `seed`.
  void fill(std::uint32_t seed);
  void reverse();
  // Merge sort: stable, with the same number of comparisons for any order.
  void sort_by_value();
  void sort_by_place();
  // The record of this place, to the front. Nothing where there is none.
  const Record* find(std::int16_t place);
  std::uint16_t checksum() const;
  std::int16_t first_value() const { return first_->record->value; }

 private:
  struct Link {
    Link* next{};
    Record* record{};
  };
  using Comparison = int (*)(const Record&, const Record&);

  static int by_value(const Record& left, const Record& right);
  static int by_place(const Record& left, const Record& right);
  void sort(Comparison compare);

  std::array<Link, length> links_{};
  std::array<Record, length> records_{};
  Link* first_{};
};

}  // namespace benchmark
