// SPDX-License-Identifier: Apache-2.0
// Scripts of front ends: G-code, and the commands of Klipper that they send.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace moonraker {

struct Core;

struct Step {
  enum class Kind { wish, bed_clear, restart, print } kind;
  nlohmann::json wish;  // of the spooler, where it is one
  std::string file;  // to print
};

// While a job is under way, G-code between its lines must not change what they mean.
enum class Work { none, paused, printing };

// All steps of a script, before any of them is done. Throws Error 400 for an unknown command, a
// wrong parameter, or what may not be done while a job is under way.
std::vector<Step> steps_of(std::string_view script, Work work);

// Throws Error, and what the spooler throws. Lines are sent in their order; that one is executed is
// not waited for.
void run_script(Core& core, std::string_view script);

// The file as a job on this printer: a held one is released, one that is over printed again.
// Returns what is awaited before it starts, for people.
std::string print_file(Core& core, const std::string& name);

}  // namespace moonraker
