// SPDX-License-Identifier: Apache-2.0
// The serial port of a printer, which may come and go.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace feeder {

class Port {
 public:
  Port(std::filesystem::path path, std::uint32_t baud);
  ~Port();
  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;

  // False where there is no such port now, or another program has locked it; `fault` says why.
  bool open();
  // Why it is not open, for people; empty where it is.
  const std::string& fault() const { return fault_; }
  void close();
  bool is_open() const { return file_ >= 0; }
  int descriptor() const { return file_; }

  // Takes as much as the line takes now, without waiting; the number of bytes. Closes itself
  // where the port is gone.
  std::size_t write(std::string_view bytes);
  // What has come, without waiting; closes itself where the port is gone.
  std::string read();

 private:
  std::filesystem::path path_;
  std::uint32_t baud_;
  int file_ = -1;
  std::string fault_ = "not opened yet";
};

}  // namespace feeder
