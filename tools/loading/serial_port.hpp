// SPDX-License-Identifier: Apache-2.0
// A serial port of this machine, real or a pseudo-terminal, as a stream of bytes.
#pragma once

#include <filesystem>

#include "tools/loading/loading.hpp"

namespace loading {

class SerialPort : public ByteStream {
 public:
  // Any speed, for this program alone. Throws std::system_error.
  SerialPort(const std::filesystem::path& path, std::uint32_t baud);
  ~SerialPort() override;

  void write(std::span<const std::uint8_t> bytes) override;
  std::size_t read(std::span<std::uint8_t> bytes, std::chrono::milliseconds timeout) override;

 private:
  int file_;
};

}  // namespace loading
