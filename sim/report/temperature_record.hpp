// SPDX-License-Identifier: Apache-2.0
// Temperatures over time and how well they were held, for the hotend or the bed.
#pragma once

#include <functional>
#include <vector>

#include "sim/devices/host_listener.hpp"
#include "sim/report/gcode_path.hpp"
#include "sim/simulation/clock_rate.hpp"
#include "sim/simulation/device.hpp"

namespace report {

struct TemperatureSample {
  double seconds{};
  double celsius{};
  double target_c{};
};

struct TemperatureResult {
  double target_c{};  // the highest that the G-code asked for; 0 for none
  double max_c{};
  double seconds_to_target{};  // from the first command to within 1 degree; -1 where never
  double band_c{};  // largest distance from the target while it was held, from M109 or M190 done on
};

class TemperatureRecord : public sim::Device, public devices::HostListener {
 public:
  // `celsius` reads the true temperature of the plant.
  TemperatureRecord(bool bed, sim::ClockRate rate, std::function<double()> celsius);

  void wake(sim::Clock now) override;
  void command_sent(sim::Clock now, std::size_t file_line, std::string_view command) override;
  void command_acknowledged(sim::Clock now, std::size_t file_line, std::string_view command,
                            bool executed) override;

  double celsius() const { return celsius_(); }
  double target_c() const { return target_c_; }
  const std::vector<TemperatureSample>& samples() const { return samples_; }
  TemperatureResult result() const;

 private:
  bool bed_;
  sim::ClockRate rate_;
  std::function<double()> celsius_;
  GcodePath gcode_;
  std::vector<TemperatureSample> samples_;
  double target_c_ = 0;
  double first_asked_seconds_ = 0;
  bool held_ = false;
  TemperatureResult result_{.target_c = 0, .max_c = -300, .seconds_to_target = -1, .band_c = 0};
};

}  // namespace report
