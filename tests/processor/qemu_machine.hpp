// SPDX-License-Identifier: Apache-2.0
// QEMU running a program one instruction at a time, with its registers before each.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <vector>

#include "tests/processor/qemu_record.hpp"
#include "tools/process/process.hpp"

namespace processor {

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
  std::optional<QemuRecord> next();

 private:
  // After the warnings that QEMU starts with.
  void find_first_record();

  std::filesystem::path image_file_;
  std::optional<process::Process> process_;
  std::FILE* records_ = nullptr;
};

}  // namespace processor
