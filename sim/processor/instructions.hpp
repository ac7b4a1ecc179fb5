// SPDX-License-Identifier: Apache-2.0
// Instructions as the specification defines them, apart from any state.
#pragma once

#include <cstdint>
#include <optional>

namespace processor {

// The instruction of 32 bits for which a compressed one stands; nothing where it is reserved.
std::optional<std::uint32_t> expand_compressed(std::uint16_t instruction);

// What the instruction of Zbb gives of its two registers; nothing where it is none of these.
std::optional<std::uint32_t> bit_manipulation(std::uint32_t instruction, std::uint32_t first,
                                              std::uint32_t second);

}  // namespace processor
