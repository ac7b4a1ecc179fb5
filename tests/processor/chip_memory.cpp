// SPDX-License-Identifier: Apache-2.0
// Of a model of the sources the memory's four lanes of bytes, under the names that GHDL and
// Verilator give them (rtl/memory).
#include "tests/processor/chip_memory.hpp"

#include <Vprocessor_with_memory.h>
#include <Vprocessor_with_memory___024root.h>

namespace processor {
namespace {

auto& byte_at(const Vprocessor_with_memory& model, std::size_t place) {
  auto& root = *model.rootp;
  switch (place % 4) {
    case 0:
      return root.processor_with_memory__DOT__memory__DOT__banks_n1_lanes_n1_bytes[place / 4];
    case 1:
      return root.processor_with_memory__DOT__memory__DOT__banks_n1_lanes_n2_bytes[place / 4];
    case 2:
      return root.processor_with_memory__DOT__memory__DOT__banks_n1_lanes_n3_bytes[place / 4];
    default:
      return root.processor_with_memory__DOT__memory__DOT__banks_n1_lanes_n4_bytes[place / 4];
  }
}

}  // namespace

std::uint8_t read_byte(const Vprocessor_with_memory& model, std::size_t place) {
  return byte_at(model, place);
}

void write_byte(Vprocessor_with_memory& model, std::size_t place, std::uint8_t byte) {
  byte_at(model, place) = byte;
}

}  // namespace processor
