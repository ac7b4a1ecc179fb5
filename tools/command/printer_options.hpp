// SPDX-License-Identifier: Apache-2.0
// Options of every job with a simulated printer, and bounds that several jobs share.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

#include "tools/command/printer_setup.hpp"

namespace command {

constexpr std::uint32_t lowest_clock_hz = 4'000'000;
constexpr std::uint32_t highest_clock_hz = 100'000'000;
constexpr int lowest_baud = 1'200;
constexpr int highest_baud = 3'000'000;

void add_printer_options(CLI::App& job, PrinterChoices& choices);

}  // namespace command
