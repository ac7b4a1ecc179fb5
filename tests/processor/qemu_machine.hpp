// SPDX-License-Identifier: Apache-2.0
// QEMU running a program one instruction at a time, with its registers before each.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tools/process/process.hpp"

namespace processor {

// State in QEMU's log before an instruction.
struct QemuState {
  std::uint32_t program_counter = 0;
  std::uint32_t mtvec = 0;
  std::uint32_t mepc = 0;
  std::uint32_t mcause = 0;
  std::uint32_t mtval = 0;
  std::uint32_t mscratch = 0;
  std::array<std::uint32_t, 32> registers{};
};

// RV32IMC with machine mode only, its memory where the chip's is, without the chip's peripherals.
class QemuMachine {
 public:
  // Starts it with the image at the start of the memory, for RV32IMC with or without Zbb. Throws
  // std::runtime_error where it cannot.
  QemuMachine(const std::vector<std::uint8_t>& image, bool has_zbb);
  ~QemuMachine();
  QemuMachine(const QemuMachine&) = delete;
  QemuMachine& operator=(const QemuMachine&) = delete;

  // Before the next instruction; from the first of the image on. Nothing where QEMU has ended.
  std::optional<QemuState> next();

 private:
  bool read_line();

  std::filesystem::path image_file_;
  std::optional<process::Process> process_;
  std::FILE* log_ = nullptr;
  std::array<char, 256> line_{};
};

}  // namespace processor
