// SPDX-License-Identifier: Apache-2.0
// Reads NAME=PORT and simulated:N.
#include "host/spooler/printer_spec.hpp"

#include <algorithm>
#include <charconv>
#include <set>
#include <stdexcept>

namespace spooler {

namespace {

constexpr std::size_t longest_name = 32;
constexpr int most_simulated = 16;
constexpr std::string_view simulated = "simulated";

bool is_name(std::string_view name) {
  return !name.empty() && name.size() <= longest_name && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_';
  });
}

void add_simulated(std::string_view text, std::vector<PrinterSpec>& printers) {
  if (text == simulated) {
    printers.push_back({.name = std::string(simulated), .port = {}});
    return;
  }
  const std::string_view count = text.substr(simulated.size() + 1);
  int number = 0;
  const auto [end, error] = std::from_chars(count.data(), count.data() + count.size(), number);
  if (error != std::errc{} || end != count.data() + count.size() || number < 1 ||
      number > most_simulated) {
    throw std::runtime_error("--printer " + std::string(text) + ": 1 to 16 can be simulated");
  }
  for (int i = 1; i <= number; ++i) {
    printers.push_back({.name = std::string(simulated) + "-" + std::to_string(i), .port = {}});
  }
}

}  // namespace

std::vector<PrinterSpec> printers_of(const std::vector<std::string>& texts) {
  std::vector<PrinterSpec> printers;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    if (text == simulated || text.starts_with(std::string(simulated) + ":")) {
      add_simulated(text, printers);
    } else if (equals == std::string::npos || equals + 1 == text.size()) {
      throw std::runtime_error("--printer " + text + ": neither NAME=PORT nor simulated[:N]");
    } else if (!is_name(text.substr(0, equals))) {
      throw std::runtime_error("--printer " + text +
                               ": a name has 1 to 32 letters, digits, - and _");
    } else {
      printers.push_back({.name = text.substr(0, equals), .port = text.substr(equals + 1)});
    }
  }
  std::set<std::string> names, ports;
  for (const PrinterSpec& printer : printers) {
    if (!names.insert(printer.name).second) {
      throw std::runtime_error("two printers are named " + printer.name);
    }
    if (!printer.port.empty() && !ports.insert(printer.port.string()).second) {
      throw std::runtime_error("two printers at " + printer.port.string());
    }
  }
  return printers;
}

}  // namespace spooler
