// SPDX-License-Identifier: Apache-2.0
// The FPGAs that `synth` knows, by the names that nextpnr gives them.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace synthesis {

enum class Family { ecp5, ice40 };

struct Device {
  std::string_view name;
  Family family;
  // Memory of the processor when it is measured alone. An iCE40's block RAM has one port to read:
  // the memory, which has two, takes twice its size, and the registers four blocks.
  std::uint32_t memory_bytes;
  // Lattice FPGA-DS-02012 and FPGA-DS-02029 (HX8K), FPGA-DS-02008 (UP5K): of 18 kbit, of 4 kbit.
  std::uint32_t block_rams;
};

// A 12F is a 25F of which the maker promises a part.
constexpr std::array devices{
    Device{"12k", Family::ecp5, 65536, 56},  Device{"25k", Family::ecp5, 65536, 56},
    Device{"45k", Family::ecp5, 65536, 108}, Device{"85k", Family::ecp5, 65536, 208},
    Device{"hx8k", Family::ice40, 4096, 32}, Device{"up5k", Family::ice40, 4096, 30}};

// Bytes of memory in a block RAM of an ECP5: its ninth bits are not used.
constexpr std::uint32_t ecp5_block_bytes = 2048;

constexpr const char* name_of(Family family) {
  switch (family) {
    case Family::ecp5:
      return "ECP5";
    case Family::ice40:
      return "iCE40";
  }
  return "";
}

// Throws std::out_of_range where there is none of this name.
const Device& device_named(std::string_view name);

}  // namespace synthesis
