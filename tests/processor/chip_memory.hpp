// SPDX-License-Identifier: Apache-2.0
// The memory inside a model of the processor with its memory, byte by byte: how it is reached
// depends on what the model was made of.
#pragma once

#include <cstddef>
#include <cstdint>

class Vprocessor_with_memory;

namespace processor {

// `place` counts from the memory's begin. The model has been evaluated before.
std::uint8_t read_byte(const Vprocessor_with_memory& model, std::size_t place);
void write_byte(Vprocessor_with_memory& model, std::size_t place, std::uint8_t byte);

}  // namespace processor
