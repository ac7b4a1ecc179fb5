// SPDX-License-Identifier: Apache-2.0
// Which printers a spooler has, as the command line says it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace spooler {

struct PrinterSpec {
  std::string name;  // letters, digits, - and _, at most 32
  std::filesystem::path port;  // empty: a simulated printer
  bool operator==(const PrinterSpec&) const = default;
};

// Each text is NAME=PORT or simulated[:N]; `simulated` gives the names simulated, or simulated-1 to
// simulated-N. Throws std::runtime_error with what is wrong.
std::vector<PrinterSpec> printers_of(const std::vector<std::string>& texts);

}  // namespace spooler
