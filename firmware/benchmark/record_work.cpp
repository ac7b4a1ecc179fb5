// SPDX-License-Identifier: Apache-2.0
// Calls that the compiler may not draw together, as in programs of many files.
#include "benchmark/record_work.hpp"

#include "benchmark/checksum.hpp"

namespace benchmark {

namespace {

constexpr std::string_view second_name = "a text of thirty-one letters, 2";
constexpr std::string_view third_name = "a text of thirty-one letters, 3";
constexpr std::uint32_t many = 20;  // rows of the table

}  // namespace

void RecordWork::prepare(std::string_view) {
  records_[0].next = &records_[1];
  records_[1].next = &records_[2];
  records_[2].next = records_.data();
  copy(left_, second_name);
  for (Record& record : records_) copy(record.name, second_name);
}

[[gnu::noinline]] void RecordWork::copy(Name& to, std::string_view from) {
  std::size_t place = 0;
  for (; place < from.size(); ++place) to[place] = from[place];
  to[place] = '\0';
}

[[gnu::noinline]] int RecordWork::compare(const Name& left, const Name& right) {
  const char* first = left.data();
  const char* second = right.data();
  while (*first == *second && *first != '\0') {
    ++first;
    ++second;
  }
  return *first - *second;
}

[[gnu::noinline]] RecordWork::Kind RecordWork::successor(Kind kind) {
  switch (kind) {
    case Kind::first:
      return Kind::second;
    case Kind::second:
      return Kind::third;
    case Kind::third:
      return Kind::fourth;
    case Kind::fourth:
      return Kind::fifth;
    case Kind::fifth:
      return Kind::first;
  }
  return Kind::first;
}

[[gnu::noinline]] void RecordWork::pass_on(Record& record) {
  Record& next = *record.next;
  const Record* const after = next.next;
  next.kind = successor(record.kind);
  next.number = record.number + 5;
  next.name = record.name;
  if (next.kind == Kind::first) {
    next.number = after->number / 3 + 10;
  } else {
    record.number = next.number * 7 - count_;
  }
}

[[gnu::noinline]] void RecordWork::fill_table(std::int32_t row, std::int32_t value) {
  auto& line = table_[static_cast<std::size_t>(row)];
  line[5] = value;
  line[6] = line[5];
  line[19] = row;
  for (std::size_t column = 7; column < 10; ++column) line[column] = line[column - 1] + row;
  ++line[4];
}

[[gnu::noinline]] bool RecordWork::names_in_order() {
  std::size_t place = 2;
  while (place < 4 && left_[place] != right_[place + 1]) {
    letter_ = left_[place];
    ++place;
  }
  return compare(left_, right_) <= 0;
}

ProcessorResult RecordWork::run(std::uint32_t iterations) {
  std::uint16_t sum = 0;
  for (std::uint32_t i = 0; i < iterations; ++i) {
    const auto row = static_cast<std::int32_t>(i % many);
    count_ = 0;
    copy(right_, (i & 1) != 0 ? second_name : third_name);
    if (names_in_order()) ++count_;
    fill_table(row, count_ + 3);
    for (Record& record : records_) pass_on(record);
    for (char letter = 'A'; letter <= letter_ && letter < 'D'; ++letter) count_ += letter;
    const std::int32_t product = records_[0].number * (row + 1);
    const std::int32_t quotient = product / (count_ | 1);
    records_[1].number = 7 * (product - quotient) - row;
    sum = static_cast<std::uint16_t>(sum + (quotient ^ records_[2].number));
  }
  for (const Record& record : records_) {
    sum = add_word(sum, static_cast<std::uint32_t>(record.number));
  }
  return {.units = iterations, .checksum = sum};
}

}  // namespace benchmark
