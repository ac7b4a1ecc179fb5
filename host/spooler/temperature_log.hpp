// SPDX-License-Identifier: Apache-2.0
// The last minutes of a printer's heaters, so that a page that is opened later shows them too.
#pragma once

#include <cstdint>
#include <deque>
#include <nlohmann/json.hpp>

#include "host/spooler/feeder_state.hpp"

namespace spooler {

class TemperatureLog {
 public:
  static constexpr std::int64_t interval_ms = 2000;
  static constexpr std::size_t most_samples = 900;  // half an hour

  // What the feeder says at this time. Only a printer that answers has temperatures: there is a gap
  // where it did not.
  void take(const FeederState& state, std::int64_t time_ms);

  // When the printer last answered; 0 before.
  std::int64_t heard_ms() const { return heard_ms_; }
  // {"interval_ms": …, "samples": [[time in ms, hotend, its target, its power, bed, its target,
  // its power], …]}: °C, powers from 0 to 1, null where it is not known.
  nlohmann::json to_json() const;

 private:
  std::deque<nlohmann::json> samples_;
  std::int64_t sampled_ms_ = 0, heard_ms_ = 0;
};

}  // namespace spooler
