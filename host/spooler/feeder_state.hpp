// SPDX-License-Identifier: Apache-2.0
// What a feeder says of itself and its printer.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace spooler {

struct FeederState {
  std::string link;  // closed, asking, ready
  std::optional<std::int64_t> job;
  std::string phase;  // of the job; empty without one
  std::string why;
  std::string fault;  // of port or journal, for people; or empty
  std::int64_t done{};
  std::int64_t commands{};
  bool waits_for_user{};
  double hotend_to_restore{};  // by resuming, after a long pause; 0: nothing
  std::uint64_t resends{};
  std::string homed;  // some of `xyz`
  // In degrees Celsius; powers from 0 to 1.
  std::optional<double> hotend, hotend_target, hotend_power, bed, bed_target, bed_power;
  // As the printer reports it: {"mm": [X, Y, Z, E], "steps": [X, Y, Z]}; null before.
  nlohmann::json position;
  bool operator==(const FeederState&) const = default;
};

// Throws nlohmann's exceptions where it is none.
FeederState feeder_state_of(const nlohmann::json& message);
// Finished, cancelled, failed or interrupted.
bool is_over(const FeederState& state);

}  // namespace spooler
