// SPDX-License-Identifier: Apache-2.0
// Records, texts and procedure calls: the everyday work of a program without loops over numbers.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "benchmark/processor.hpp"

namespace benchmark {

class RecordWork {
 public:
  void prepare(std::string_view text);
  ProcessorResult run(std::uint32_t iterations);

 private:
  static constexpr std::size_t name_length = 32;
  using Name = std::array<char, name_length>;
  enum class Kind : std::uint8_t { first, second, third, fourth, fifth };

  struct Record {
    Record* next{};
    Kind kind{};
    std::int32_t number{};
    Name name{};
  };

  static void copy(Name& to, std::string_view from);
  static int compare(const Name& left, const Name& right);
  static Kind successor(Kind kind);
  void pass_on(Record& record);
  void fill_table(std::int32_t row, std::int32_t value);
  bool names_in_order();

  std::array<Record, 3> records_{};
  Name left_{}, right_{};
  std::array<std::array<std::int32_t, 20>, 20> table_{};
  std::int32_t count_{};
  char letter_{};
};

}  // namespace benchmark
