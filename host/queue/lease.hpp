// SPDX-License-Identifier: Apache-2.0
// Who has which printer, where several spoolers have one queue.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace queue {

// A spooler as the others see it.
struct Member {
  std::string id;  // of its data folder: the same one after a restart
  std::string boot;  // of its machine: another one after the machine's start
  std::string place;  // for people: where it runs
  std::chrono::milliseconds lease_time{15'000};
};

struct Lease {
  std::string printer;
  std::string place;  // of the spooler that has it, or had it last
  bool is_mine = false;
  bool is_over = false;  // no spooler has it
  bool operator==(const Lease&) const = default;
};

// Milliseconds since the machine's start; they go on while it sleeps.
std::int64_t boot_ms();
// Of the machine's present run.
std::string boot_id();

}  // namespace queue
