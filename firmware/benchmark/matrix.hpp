// SPDX-License-Identifier: Apache-2.0
// Square matrices of 16-bit numbers, multiplied with each other and with a vector.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace benchmark {

class MatrixWork {
 public:
  static constexpr std::size_t size = 9;

  void fill(std::uint32_t seed);
  // Scales, multiplies in two ways and scales back. The checksum of all products.
  std::uint16_t run(std::int16_t factor);

 private:
  using Half = std::array<std::array<std::int16_t, size>, size>;
  using Full = std::array<std::array<std::int32_t, size>, size>;

  void add(std::int16_t value);
  void scale(std::int16_t factor);
  void multiply_by_vector();
  void multiply();
  void multiply_parts();
  std::uint16_t checksum() const;

  Half left_{};
  Half right_{};
  Full product_{};
};

}  // namespace benchmark
