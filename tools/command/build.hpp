// SPDX-License-Identifier: Apache-2.0
// Where the project and its build lie, and building what a job needs beyond this program.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/simulation/elf_image.hpp"

namespace command {

std::filesystem::path project_folder();
// STEPFABRIC_BUILD_DIR, or where this program was built.
std::filesystem::path build_folder();

// Builds targets, with the output in <build>/build.log. Throws std::runtime_error with
// the end of the log. On a signal it ends what it has started and throws Interrupted (signals.hpp).
void build(const std::vector<std::string>& targets);

// The firmware for another machine than that of the build, with `hardware` or `software` stepping.
// Throws std::runtime_error with the end of the log, or with what is wrong with the description.
sim::ElfImage firmware_for(const std::filesystem::path& description, const std::string& stepping);

// The same for a board, as a file. Returns the bytes of memory that the chip must have. Throws
// std::runtime_error also for a machine with two hotends: the boards have pins for one.
std::uint32_t write_board_firmware(const std::filesystem::path& description,
                                   const std::filesystem::path& file);

// Runs a program with this one's terminal and waits for it; returns its exit status (128 + signal).
// On a signal it ends what it has started and throws Interrupted.
int run_program(const std::vector<std::string>& arguments);

}  // namespace command
