// SPDX-License-Identifier: Apache-2.0
// A distance that is covered in equal parts, without a division for each.
#pragma once

#include <cstdint>

namespace motion {

// Counts from 0 in steps of total / parts, always rounded down. After 2^16 parts it is less than
// 2^-16 of one unit off.
class Share {
 public:
  constexpr Share() = default;
  constexpr Share(std::int64_t total, std::uint32_t parts) {
    whole_step_ = total / parts;
    std::int64_t rest = total - whole_step_ * parts;
    if (rest < 0) {
      rest += parts;
      --whole_step_;
    }
    part_step_ = static_cast<std::uint32_t>((static_cast<std::uint64_t>(rest) << 32) / parts);
  }

  constexpr void advance() {
    const std::uint32_t before = part_;
    part_ += part_step_;
    whole_ += whole_step_ + (part_ < before ? 1 : 0);
  }
  // What is covered by a part, modulo 2^32, in 2^-32.
  constexpr std::uint64_t step() const {
    return (static_cast<std::uint64_t>(whole_step_) << 32) + part_step_;
  }
  constexpr std::int64_t covered() const { return whole_; }

 private:
  std::int64_t whole_{}, whole_step_{};
  std::uint32_t part_{}, part_step_{};  // 2^-32
};

}  // namespace motion
