// SPDX-License-Identifier: Apache-2.0
// Sums of products, in plain loops.
#include "benchmark/matrix.hpp"

#include "benchmark/checksum.hpp"

namespace benchmark {

void MatrixWork::fill(std::uint32_t seed) {
  for (std::size_t row = 0; row < size; ++row) {
    for (std::size_t column = 0; column < size; ++column) {
      seed = seed * 1'103'515'245u + 12'345u;
      left_[row][column] = static_cast<std::int16_t>(seed >> 24);
      right_[row][column] = static_cast<std::int16_t>(seed >> 16 & 0xFF);
    }
  }
}

std::uint16_t MatrixWork::run(std::int16_t factor) {
  add(factor);
  scale(factor);
  std::uint16_t sum = checksum();
  multiply_by_vector();
  sum = add_half_word(sum, checksum());
  multiply();
  sum = add_half_word(sum, checksum());
  multiply_parts();
  sum = add_half_word(sum, checksum());
  add(static_cast<std::int16_t>(-factor));
  return sum;
}

void MatrixWork::add(std::int16_t value) {
  for (auto& row : left_) {
    for (auto& element : row) element = static_cast<std::int16_t>(element + value);
  }
}

void MatrixWork::scale(std::int16_t factor) {
  for (std::size_t row = 0; row < size; ++row) {
    for (std::size_t column = 0; column < size; ++column) {
      product_[row][column] = left_[row][column] * factor;
    }
  }
}

void MatrixWork::multiply_by_vector() {
  for (std::size_t row = 0; row < size; ++row) {
    std::int32_t sum = 0;
    for (std::size_t column = 0; column < size; ++column) {
      sum += left_[row][column] * right_[0][column];
    }
    product_[row][0] = sum;
  }
}

void MatrixWork::multiply() {
  for (std::size_t row = 0; row < size; ++row) {
    for (std::size_t column = 0; column < size; ++column) {
      std::int32_t sum = 0;
      for (std::size_t i = 0; i < size; ++i) sum += left_[row][i] * right_[i][column];
      product_[row][column] = sum;
    }
  }
}

// Only two parts of each product count: bits 2 to 5 times bits 5 to 11.
void MatrixWork::multiply_parts() {
  for (std::size_t row = 0; row < size; ++row) {
    for (std::size_t column = 0; column < size; ++column) {
      std::uint32_t sum = 0;
      for (std::size_t i = 0; i < size; ++i) {
        const auto value = static_cast<std::uint32_t>(left_[row][i] * right_[i][column]);
        sum += (value >> 2 & 0xFu) * (value >> 5 & 0x7Fu);
      }
      product_[row][column] = static_cast<std::int32_t>(sum);
    }
  }
}

// Of the sums of the rows, clipped: branches that depend on the data.
std::uint16_t MatrixWork::checksum() const {
  std::uint16_t result = 0;
  std::int32_t previous = 0;
  for (const auto& row : product_) {
    std::int32_t sum = 0;
    for (const std::int32_t element : row) {
      sum += element;
      if (sum > 30'000) {
        result = static_cast<std::uint16_t>(result + 10);
        sum = 0;
      } else {
        result = static_cast<std::uint16_t>(result + (element > previous ? 1 : 0));
      }
      previous = element;
    }
    result = add_half_word(result, static_cast<std::uint16_t>(sum));
  }
  return result;
}

}  // namespace benchmark
