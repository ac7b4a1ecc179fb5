// SPDX-License-Identifier: Apache-2.0
// The temperatures of the last minutes, as front ends draw them.
#pragma once

#include <deque>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>

namespace moonraker {

// For any thread.
class TemperatureStore {
 public:
  static constexpr std::size_t longest = 1200;  // samples, one each second

  // Of the printer's objects; a heater whose temperature is not known is not sampled.
  void sample(const nlohmann::json& objects);
  nlohmann::json stored() const;

 private:
  struct Series {
    std::deque<double> temperatures, targets, powers;
  };
  mutable std::mutex mutex_;
  std::map<std::string, Series> heaters_;
};

}  // namespace moonraker
